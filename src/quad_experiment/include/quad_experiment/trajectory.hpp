/// The record of a flight and its file, trajectory.csv.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "quad_control/flight_controller.hpp"
#include "quad_control/mixer.hpp"
#include "quad_experiment/plant.hpp"
#include "quad_sim/state.hpp"

namespace quad_experiment {

/// Seconds of a simulated time, which is counted in whole ns.
inline double seconds(std::int64_t ns) { return static_cast<double>(ns) / 1e9; }

/// Row k: the state at t_k, the command computed from it, and what was measured at the end of the
/// interval, t_{k+1}.
struct TrajectoryRow {
  quad_sim::Measurement state;            ///< at t_k
  quad_control::ControlOutput command;    ///< computed from that state
  std::vector<double> rotor_speed_after;  ///< unsigned [rad/s] at t_{k+1}
  std::int64_t next_time_ns = 0;          ///< t_{k+1}
  bool exploring = false;
  bool last = false;  ///< the final state: no interval follows, no inputs
};

struct Trajectory {
  std::vector<TrajectoryRow> rows;

  /// Index of the row k = 0: the state at the end of the hold. rows.size() if nothing was explored.
  std::size_t firstExplored() const;
};

/// The exploration's data for identification: x = [z; zdot], u = T_eff^FB, thesis section 2.4.4.
struct ExplorationData {
  Eigen::MatrixXd X;          ///< 2 x (T+1): z [m], zdot [m/s]
  Eigen::MatrixXd t_eff_fb;   ///< 1 x T: rebuilt thrust minus feed-forward [N]
  Eigen::MatrixXd u1_fb;      ///< 1 x T: rebuilt thrust [N]
  Eigen::MatrixXd t_eff_cmd;  ///< 1 x T: commanded [N], before any clamping
};

/// @param feedforward  m_hat g [N]
ExplorationData explorationData(const Trajectory& trajectory, const quad_control::Mixer& mixer,
                                double feedforward);

/// Climb rate [m/s] in world axes from an odometry, whose twist is in body axes.
double climbRate(const quad_sim::Odometry& odometry);

/// trajectory.csv: k (0 at the end of the hold, negative before), t [s], dt [s], phase, z [m], zdot
/// [m/s], x, y [m], phi, theta, psi [rad], u1_cmd, u1_fb, t_eff_cmd, t_eff_fb [N], tau_phi,
/// tau_theta, tau_psi [N m], w0 … [rad/s]. Doubles are printed so that they read back exactly; the
/// last row has no dt and no inputs (empty cells).
std::string toCsv(const Trajectory& trajectory, const quad_control::Mixer& mixer,
                  double feedforward);

/// timing.csv of a flight on the wall clock (thesis Figs 1.6, 1.7): k, t as in trajectory.csv, dT,
/// dT_ctrl, service_delay, estimated_delay [s]; one row an interval. @throws std::invalid_argument
/// unless there is an entry for each
std::string timingCsv(const Trajectory& trajectory, const std::vector<IntervalTiming>& timing);

}  // namespace quad_experiment
