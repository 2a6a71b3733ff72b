#include "quirky_rotor_plugin.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace quad_sim {

using Eigen::Vector3d;

QuirkyRotorPlugin::QuirkyRotorPlugin(const VehicleModel& model, const WorldSettings& world)
    : models_(model.rotors), quirks_(world.quirks), step_(world.step) {
  for (const RotorModel& m : models_) rotors_.push_back({&m, m.position_B - model.com_B, 0.0});
}

QuirkyRotorPlugin::Means QuirkyRotorPlugin::filter(Rotor& r, double command, double dt) const {
  const double before = r.speed;
  const double tau = command > before ? r.model->time_constant_up : r.model->time_constant_down;
  const double x = dt / tau, a = std::exp(-x);
  r.speed = a * before + (1 - a) * command;
  if (quirks_.thrust_lag)
    return {before, before * std::abs(before)};  // the forces were taken before the filter ran
  const double d = before - command, mean = -std::expm1(-x) / x,
               mean_square = -std::expm1(-2 * x) / (2 * x);
  const double square = command * command + d * (2 * command * mean + d * mean_square);
  return {command + d * mean, std::copysign(square, before + r.speed)};
}

void QuirkyRotorPlugin::addLoad(const Rotor& r, const Means& mean, const StepInput& input,
                                StepLoad& load) const {
  const RotorModel& m = *r.model;
  const Vector3d thrust = m.thrust_coefficient * mean.square * m.axis_B;
  const Vector3d v = input.v_WC_B + input.w_WB_B.cross(r.hub_C);
  const Vector3d swept = std::abs(mean.speed) * (v - m.axis_B * m.axis_B.dot(v));
  const Vector3d force = thrust - m.drag_coefficient * swept;
  const double side = quirks_.rolling_moment_sign ? 1.0 : m.spin;
  load.force_B += force;
  load.torque_B += r.hub_C.cross(force) - m.spin * m.torque_ratio * thrust -
                   side * m.rolling_moment_coefficient * swept;
}

void QuirkyRotorPlugin::step(const StepInput& input, StepLoad& load) {
  // RotorS takes the time since the filter last ran; after a reset that left the filter alone it is
  // negative, once.
  const double end = input.time + step_;
  const double dt = quirks_.filter_survives_reset ? end - last_time_ : step_;
  last_time_ = end;
  const double* command = input.command;
  for (Rotor& r : rotors_) {
    const Means mean = filter(r, *command++, dt);
    addLoad(r, mean, input, load);
    const Vector3d per_speed = r.model->spin * r.model->axial_inertia * r.model->axis_B;
    load.momentum_end_B += r.speed * per_speed;
    // RotorS sets the joint's new speed before the bodies move.
    load.momentum_mean_B += (quirks_.thrust_lag ? r.speed : mean.speed) * per_speed;
  }
}

void QuirkyRotorPlugin::restore(const VehicleState& state) {
  for (std::size_t i = 0; i < rotors_.size(); ++i) rotors_[i].speed = state.rotor_speed[i];
}

void QuirkyRotorPlugin::reset(const VehicleState& state) {
  if (!quirks_.filter_survives_reset) restore(state);
}

void QuirkyRotorPlugin::save(VehicleState& state) const {
  state.rotor_speed.resize(rotors_.size());
  for (std::size_t i = 0; i < rotors_.size(); ++i) state.rotor_speed[i] = rotors_[i].speed;
}

void QuirkyRotorPlugin::archive(StateArchive& archive) {
  for (Rotor& r : rotors_) archive(r.speed);
  archive(last_time_);
}

Vector3d QuirkyRotorPlugin::momentum() const {
  Vector3d sum = Vector3d::Zero();
  for (const Rotor& r : rotors_)
    sum += r.speed * r.model->spin * r.model->axial_inertia * r.model->axis_B;
  return sum;
}

}  // namespace quad_sim
