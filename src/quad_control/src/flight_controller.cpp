#include "quad_control/flight_controller.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "quad_support/constants.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

using quad_support::ConfigError;

using quad_support::kPi;

// The torque about `axis` that the rotors can add to `thrust`, the other torques zero.
OutputLimits torqueLimits(const Mixer& mixer, double thrust, int axis) {
  const double margin = mixer.margin({thrust, 0.0, 0.0, 0.0}, axis);
  return {-margin, margin};
}

void check(const FlightPlan& plan, double max_thrust) {
  const auto require = [](bool ok, const char* what, double value, const std::string& limit) {
    if (!ok) throw ConfigError(fmt::format("flight plan: {} = {}; must be {}", what, value, limit));
  };
  const References& r = plan.references;
  for (const double value : {r.x, r.y, r.z, r.yaw})
    require(std::isfinite(value), "a reference", value, "finite");
  require(plan.feed_forward_mass > 0.0, "feed_forward_mass", plan.feed_forward_mass, "> 0 kg");
  require(plan.gravity > 0.0, "gravity", plan.gravity, "> 0 m/s^2");
  require(std::isfinite(plan.initial_altitude_effort), "initial_altitude_effort",
          plan.initial_altitude_effort, "finite");
  const double feed_forward = plan.feed_forward_mass * plan.gravity;
  require(feed_forward < max_thrust, "feed_forward_mass * gravity", feed_forward,
          fmt::format("below the rotors' {:.4g} N", max_thrust));
  for (const double value : plan.exploration_signal) {
    require(std::isfinite(value), "a sample of exploration_signal", value, "finite");
  }
}

void check(const quad_sim::Odometry& odometry) {
  const bool finite = odometry.p_WB.allFinite() && odometry.q_WB.coeffs().allFinite() &&
                      odometry.v_WB_B.allFinite() && odometry.w_WB_B.allFinite();
  if (finite && odometry.q_WB.norm() > 0.0) return;
  throw quad_support::SimulationError(
      fmt::format("control: the odometry of t = {:.3f} s is not finite: the flight has diverged",
                  1e-9 * static_cast<double>(odometry.time_ns)));
}

}  // namespace

Eigen::Vector3d rollPitchYaw(const Eigen::Quaterniond& q_WB) {
  const Eigen::Matrix3d R_WB = q_WB.normalized().toRotationMatrix();
  return {std::atan2(R_WB(2, 1), R_WB(2, 2)), std::asin(std::clamp(-R_WB(2, 0), -1.0, 1.0)),
          std::atan2(R_WB(1, 0), R_WB(0, 0))};
}

double wrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

TiltReference positionLoop(const References& references, const quad_sim::Odometry& odometry,
                           double gravity) {
  constexpr double kBandwidth = 0.3, kMaxTilt = 0.15;  // [rad/s], [rad]
  const Eigen::Vector3d v_WB = odometry.q_WB.normalized() * odometry.v_WB_B;
  const double ax = kBandwidth * (kBandwidth * (references.x - odometry.p_WB.x()) - 2.0 * v_WB.x());
  const double ay = kBandwidth * (kBandwidth * (references.y - odometry.p_WB.y()) - 2.0 * v_WB.y());
  const double yaw = rollPitchYaw(odometry.q_WB).z();
  const double ahead = ax * std::cos(yaw) + ay * std::sin(yaw);
  const double left = ay * std::cos(yaw) - ax * std::sin(yaw);
  return {std::clamp(-left / gravity, -kMaxTilt, kMaxTilt),
          std::clamp(ahead / gravity, -kMaxTilt, kMaxTilt)};
}

std::vector<RotorGeometry> rotorGeometry(const quad_sim::VehicleModel& vehicle) {
  std::vector<RotorGeometry> rotors;
  for (const auto& rotor : vehicle.rotors) {
    rotors.push_back({rotor.position_B - vehicle.com_B, rotor.axis_B, rotor.spin,
                      rotor.thrust_coefficient, rotor.torque_ratio, rotor.max_speed});
  }
  return rotors;
}

double equilibriumEffort(double flown_mass, double feed_forward_mass, double gravity) {
  return (flown_mass - feed_forward_mass) * gravity;
}

FlightController::FlightController(const std::vector<RotorGeometry>& rotors,
                                   const ControlConfig& config)
    : mixer_(rotors), config_(config) {}

FlightController::FlightController(const quad_sim::VehicleModel& vehicle,
                                   const ControlConfig& config)
    : FlightController(rotorGeometry(vehicle), config) {}

void FlightController::begin(const FlightPlan& plan) {
  check(plan, mixer_.maxThrust());
  const double feed_forward = plan.feed_forward_mass * plan.gravity;
  const double period = config_.sampling_period;
  Loops loops{
      PiController(config_.roll_pitch, period, torqueLimits(mixer_, feed_forward, 1)),
      PiController(config_.roll_pitch, period, torqueLimits(mixer_, feed_forward, 2)),
      PiController(config_.yaw, period, torqueLimits(mixer_, feed_forward, 3)),
      PiController(config_.altitude, period, {-feed_forward, mixer_.maxThrust() - feed_forward})};
  loops.altitude.reset(plan.initial_altitude_effort);  // the one thing below that can throw
  plan_ = plan;
  loops_ = loops;
  feed_forward_ = feed_forward;
  restart();
}

void FlightController::restart() {
  loops_->roll.reset();
  loops_->pitch.reset();
  loops_->yaw.reset();
  loops_->altitude.reset(plan_->initial_altitude_effort);
  next_sample_ = 0;
  after_signal_ = 0;
  record_.clear();
}

void FlightController::setReferences(const References& references) {
  if (!plan_) throw std::logic_error("FlightController: references before begin()");
  FlightPlan moved = *plan_;
  moved.references = references;
  check(moved, mixer_.maxThrust());
  plan_->references = references;
}

double FlightController::effectiveThrust(const quad_sim::Odometry& odometry, ControlOutput& out) {
  if (!plan_->exploration_signal.empty() && odometry.time_ns >= plan_->exploration_start_ns) {
    out.exploring = true;
    if (next_sample_ == plan_->exploration_signal.size()) {
      ++after_signal_;
      return 0.0;
    }
    return plan_->exploration_signal[next_sample_++];
  }
  const double climb = (odometry.q_WB.normalized() * odometry.v_WB_B).z();  // ż, world axes [m/s]
  return loops_->altitude.update(plan_->references.z - odometry.p_WB.z(), -climb);
}

const ControlOutput& FlightController::update(const quad_sim::Odometry& odometry) {
  if (!plan_) throw std::logic_error("FlightController: update before begin()");
  check(odometry);
  if (!record_.empty()) {
    if (odometry.time_ns == record_.back().time_ns) return record_.back();
    if (odometry.time_ns < record_.back().time_ns) restart();
  }
  ControlOutput out;
  out.time_ns = odometry.time_ns;
  const Eigen::Vector3d angles = rollPitchYaw(odometry.q_WB);
  const Eigen::Vector3d& rates = odometry.w_WB_B;
  out.t_eff = effectiveThrust(odometry, out);
  out.thrust = out.t_eff + feed_forward_;
  TiltReference tilt;
  if (config_.position_loop && !out.exploring)
    tilt = positionLoop(plan_->references, odometry, plan_->gravity);
  out.tau_phi = loops_->roll.update(tilt.roll - angles.x(), -rates.x());
  out.tau_theta = loops_->pitch.update(tilt.pitch - angles.y(), -rates.y());
  out.tau_psi = loops_->yaw.update(wrapAngle(plan_->references.yaw - angles.z()), -rates.z());
  Allocation allocation = mixer_.allocate({out.thrust, out.tau_phi, out.tau_theta, out.tau_psi});
  out.rotor_speed = std::move(allocation.rotor_speed);
  out.clamped = allocation.clamped;
  return append(std::move(out));
}

const ControlOutput& FlightController::append(ControlOutput&& out) {
  if (after_signal_ > kKeptAnswers) return record_.back() = std::move(out);
  if (plan_->exploration_signal.empty() &&
      record_.size() + 1 == 2 * kKeptAnswers) {  // seldom, so it costs next to nothing
    record_.erase(record_.begin(), record_.begin() + static_cast<std::ptrdiff_t>(kKeptAnswers));
  }
  record_.push_back(std::move(out));
  return record_.back();
}

}  // namespace quad_control
