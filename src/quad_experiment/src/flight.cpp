#include "quad_experiment/flight.hpp"

#include <fmt/core.h>

#include <cmath>

#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"

namespace quad_experiment {
namespace {

/// No multirotor goes beyond; numbers that grow without end stop here, long before they overflow.
constexpr double kFarthest = 1e6;  // [m]
constexpr double kFastest = 1e4;   // [m/s], [rad/s]

/// False for NaN too.
bool isPlausible(const quad_sim::Odometry& o) {
  return o.p_WB.norm() < kFarthest && o.v_WB_B.norm() < kFastest && o.w_WB_B.norm() < kFastest &&
         o.q_WB.coeffs().allFinite();
}

void requireFlying(const quad_sim::Measurement& now) {
  const quad_sim::Odometry& o = now.odometry;
  if (now.ground_contact_ns) {  // first, for what follows a crash is no news
    throw GroundContact(
        fmt::format("the vehicle reached the ground at {} s; raise simulation.initial_altitude",
                    seconds(*now.ground_contact_ns)));
  }
  if (!isPlausible(o)) {
    throw quad_support::SimulationError(fmt::format(
        "the simulation diverged: at {} s the vehicle is {:.3g} m away, at {:.3g} m/s and {:.3g} "
        "rad/s; no vehicle goes beyond {:g} m, {:g} m/s, {:g} rad/s",
        seconds(o.time_ns), o.p_WB.norm(), o.v_WB_B.norm(), o.w_WB_B.norm(), kFarthest, kFastest,
        kFastest));
  }
  if ((o.q_WB * Eigen::Vector3d::UnitZ()).z() < 0.0) {
    throw quad_support::SimulationError(fmt::format(
        "the vehicle is upside down at {} s, at a speed of {:.3g} m/s; the "
        "control gains hold up to the speeds of docs/design/0002: weaken the signal, shorten the "
        "flight or derive gains for it",
        seconds(o.time_ns), o.v_WB_B.norm()));
  }
}

/// Gives each row the command that answers its state; commands of other times (the final state's)
/// are left out.
void attachCommands(Trajectory& trajectory,
                    const std::vector<quad_control::ControlOutput>& commands) {
  std::size_t next = 0;
  for (TrajectoryRow& row : trajectory.rows) {
    if (row.last) return;
    const std::int64_t time = row.state.odometry.time_ns;
    while (next < commands.size() && commands[next].time_ns < time) ++next;
    if (next == commands.size() || commands[next].time_ns != time) {
      throw quad_support::EnvironmentError(
          fmt::format("the controller has no record of its command at {} s", seconds(time)));
    }
    row.command = commands[next];
  }
}

}  // namespace

Trajectory fly(Plant& plant, const FlightSpec& spec, const Middleware& middleware,
               const FlightProgress& progress) {
  const std::size_t num_samples = spec.plan.exploration_signal.size();
  Trajectory trajectory;
  quad_sim::Measurement now = plant.begin(spec.plan);
  std::size_t explored = 0;
  for (std::uint64_t index = 0;; ++index) {
    quad_support::throwIfInterrupted();
    requireFlying(now);
    TrajectoryRow row;
    row.state = now;
    row.exploring = num_samples > 0 && now.odometry.time_ns >= spec.plan.exploration_start_ns;
    row.last = num_samples > 0 ? explored == num_samples
                               : seconds(now.odometry.time_ns) >= spec.end_of_hold - 1e-9;
    if (row.exploring) ++explored;
    if (!row.last) {
      now = plant.advance(middleware.interval(index));
      row.next_time_ns = now.odometry.time_ns;
      row.rotor_speed_after = now.rotor_speed;
    }
    const bool done = row.last;
    trajectory.rows.push_back(std::move(row));
    if (done) break;
    if (progress) progress(now.odometry);
  }
  attachCommands(trajectory, plant.end());
  return trajectory;
}

}  // namespace quad_experiment
