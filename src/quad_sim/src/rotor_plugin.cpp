#include "rotor_plugin.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace quad_sim {

using Eigen::Vector3d;

RotorPlugin::Decay RotorPlugin::decayOver(double step, double time_constant) {
  const double x = step / time_constant;
  return {std::exp(-x), -std::expm1(-x) / x, -std::expm1(-2 * x) / (2 * x)};
}

RotorPlugin::RotorPlugin(const VehicleModel& model, double step) {
  for (const RotorModel& m : model.rotors) {
    Rotor r;
    r.speed = 0;
    r.up = decayOver(step, m.time_constant_up);
    r.down = decayOver(step, m.time_constant_down);
    r.hub_C = m.position_B - model.com_B;
    r.axis = m.axis_B;
    r.thrust_force = m.thrust_coefficient * m.axis_B;
    r.thrust_torque = r.hub_C.cross(r.thrust_force) - m.spin * m.torque_ratio * r.thrust_force;
    r.drag = m.drag_coefficient;
    r.rolling = m.spin * m.rolling_moment_coefficient;
    r.momentum = m.spin * m.axial_inertia * m.axis_B;
    rotors_.push_back(r);
  }
}

void RotorPlugin::step(const StepInput& input, StepLoad& load) {
  const double* command = input.command;
  for (Rotor& r : rotors_) {
    const double u = *command++;
    const double d = r.speed - u;
    const Decay& decay = d < 0 ? r.up : r.down;
    const double mean = u + d * decay.mean;
    const double mean_square = u * u + d * (2 * u * decay.mean + d * decay.mean_square);
    r.speed = u + d * decay.end;

    const Vector3d v = input.v_WC_B + input.w_WB_B.cross(r.hub_C);
    const Vector3d swept = mean * (v - r.axis * r.axis.dot(v));  // |w| v_perp
    const Vector3d h_force = -r.drag * swept;
    load.force_B += mean_square * r.thrust_force + h_force;
    load.torque_B += mean_square * r.thrust_torque + r.hub_C.cross(h_force) - r.rolling * swept;
    load.momentum_mean_B += mean * r.momentum;
    load.momentum_end_B += r.speed * r.momentum;
  }
}

void RotorPlugin::restore(const VehicleState& state) {
  for (std::size_t i = 0; i < rotors_.size(); ++i) rotors_[i].speed = state.rotor_speed[i];
}

void RotorPlugin::save(VehicleState& state) const {
  state.rotor_speed.resize(rotors_.size());
  for (std::size_t i = 0; i < rotors_.size(); ++i) state.rotor_speed[i] = rotors_[i].speed;
}

Vector3d RotorPlugin::momentum() const {
  Vector3d sum = Vector3d::Zero();
  for (const Rotor& r : rotors_) sum += r.speed * r.momentum;
  return sum;
}

}  // namespace quad_sim
