/// The prestabilising controllers of a flight: attitude, heading and altitude PI, feed-forward and
/// exploration signal.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "quad_control/control_config.hpp"
#include "quad_control/mixer.hpp"
#include "quad_control/pi_controller.hpp"
#include "quad_sim/state.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_control {

/// Pose to hold; world axes, z up.
struct References {
  double x = 0.0, y = 0.0;  ///< [m]; used by the position loop only, in the hold
  double z = 0.0;           ///< altitude [m]
  double yaw = 0.0;         ///< heading [rad]
};

/// Everything a flight needs to know beforehand, so that no sample of it depends on a message being
/// in time.
struct FlightPlan {
  References references;
  double feed_forward_mass = 0.0;  ///< m̂0 [kg] of T_FF = m̂0 g (thesis section 2.3); > 0
  double gravity = 0.0;            ///< g [m/s²]; > 0
  /// The altitude integral's part of T_eff at the first sample [N], K_I e_I0. (m − m̂0) g with the
  /// flown total mass m makes the hold begin in equilibrium.
  double initial_altitude_effort = 0.0;
  /// From the first odometry with time_ns >= this on, the signal takes the altitude PI's place.
  /// Without effect where the signal is empty: the hold then goes on for ever.
  std::int64_t exploration_start_ns = std::numeric_limits<std::int64_t>::max();
  std::vector<double>
      exploration_signal;  ///< T_eff [N], one sample an update; after the last one T_eff = 0
};

/// The answer to one odometry.
struct ControlOutput {
  std::int64_t time_ns = 0;  ///< stamp of the odometry
  double thrust = 0.0;       ///< U1 [N], before rotor speeds are clamped
  double tau_phi = 0.0;      ///< U2 [N m]
  double tau_theta = 0.0;    ///< U3 [N m]
  double tau_psi = 0.0;      ///< U4 [N m]
  double t_eff = 0.0;  ///< U1 − m̂0 g [N], as it was asked for (no rounding of the difference)
  std::vector<double> rotor_speed;  ///< command, unsigned [rad/s]
  int clamped = 0;                  ///< rotors whose command had to be clamped
  bool exploring = false;           ///< whether the signal (or the zero after its end) gave t_eff
};

/// Roll, pitch, yaw [rad] of R_WB = Rz(ψ) Ry(θ) Rx(φ), the z-y'-x'' angles of thesis Eq. (1.4); φ,
/// ψ in (−π, π], θ in [−π/2, π/2]. `q_WB` need not be normalised exactly.
Eigen::Vector3d rollPitchYaw(const Eigen::Quaterniond& q_WB);

/// `angle` [rad] moved into (−π, π] by whole turns.
double wrapAngle(double angle);

/// Roll and pitch [rad] that the attitude loops shall hold.
struct TiltReference {
  double roll = 0.0, pitch = 0.0;
};

/// The outer loop of thesis Fig. 1.2: the tilt that brings the vehicle to x, y.
///
/// Wanted acceleration a = ω²(r − p) − 2ω ṗ in world axes (critically damped, ω = 0.3 rad/s, a
/// quarter of the attitude loops' slowest pole), turned into tilt by ẍ = gθ, ÿ = −gφ of Eq. (1.5)
/// in the present heading, each within ±0.15 rad (Assumption 1). For slow vertical motion only: in
/// a fall beyond 45 m/s the rotors' drag on a tilted vehicle exceeds the thrust's sideways part,
/// and the acceleration has the other sign.
TiltReference positionLoop(const References& references, const quad_sim::Odometry& odometry,
                           double gravity);

/// The rotors of a vehicle as the allocation sees them: positions from the centre of mass.
std::vector<RotorGeometry> rotorGeometry(const quad_sim::VehicleModel& vehicle);

/// The flown total mass times gravity minus the feed-forward [N]:
/// FlightPlan::initial_altitude_effort of a hold that begins in equilibrium.
double equilibriumEffort(double flown_mass, double feed_forward_mass, double gravity);

/// Closes the loops of thesis Fig. 2.4, once an odometry.
///
/// Roll, pitch and yaw are PI-controlled with body rates as velocities (equal to the angles'
/// derivatives under the thesis's Assumption 1, and defined at any attitude); the altitude with ż =
/// (R v_WB_B)_z. U1 = T_eff + m̂0 g. Each output saturates where, from the feed-forward thrust and
/// alone, it would drive a rotor out of its range. The vehicle is held level, or tilted as
/// positionLoop() says where the configuration has it on and no signal is flown.
class FlightController {
 public:
  /// @throws quad_support::ConfigError if the rotors cannot give all of U (see Mixer)
  FlightController(const std::vector<RotorGeometry>& rotors, const ControlConfig& config);
  FlightController(const quad_sim::VehicleModel& vehicle, const ControlConfig& config);

  /// Forgets the flight before and starts this one with the next odometry.
  /// @throws quad_support::ConfigError if a figure is not finite or out of range, or the
  /// feed-forward exceeds the rotors
  void begin(const FlightPlan& plan);
  bool flying() const { return plan_.has_value(); }  ///< whether begin() has been called

  /// Moves the references of the flight; the integrals keep their values. @throws std::logic_error
  /// before begin()
  void setReferences(const References& references);

  /// The command for `odometry`, and the next sample of every sum and of the signal. The same stamp
  /// again gets the same answer and advances nothing; an earlier stamp means that the simulation
  /// was reset, and the flight starts again.
  /// @throws std::logic_error before begin(), quad_support::SimulationError if the odometry is not
  /// finite
  const ControlOutput& update(const quad_sim::Odometry& odometry);

  /// The least number of answers that record() keeps of a hold without signal; 2.8 h at 10 Hz, some
  /// 15 MB.
  static constexpr std::size_t kKeptAnswers = 100'000;

  /// The answers since begin(), in order: all of them up to the end of the signal. What can go on
  /// for ever is bounded: of a flight without signal the last kKeptAnswers to 2 kKeptAnswers - 1
  /// are kept; after the end of a signal as many follow as kKeptAnswers, of which the last is the
  /// latest.
  const std::vector<ControlOutput>& record() const { return record_; }
  const Mixer& mixer() const { return mixer_; }

 private:
  struct Loops {
    PiController roll, pitch, yaw, altitude;
  };
  void restart();
  double effectiveThrust(const quad_sim::Odometry& odometry, ControlOutput& out);
  const ControlOutput& append(ControlOutput&& out);

  Mixer mixer_;
  ControlConfig config_;
  std::optional<FlightPlan> plan_;
  std::optional<Loops> loops_;
  double feed_forward_ = 0.0;  // m̂0 g [N]
  std::size_t next_sample_ = 0;
  std::size_t after_signal_ = 0;  // answers since the signal's last sample
  std::vector<ControlOutput> record_;
};

}  // namespace quad_control
