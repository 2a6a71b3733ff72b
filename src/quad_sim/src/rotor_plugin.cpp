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
    upright_ = upright_ && m.axis_B == Vector3d::UnitZ();
    rotors_.push_back(r);
  }
}

namespace {

/// Means over the step of the speed and of its square.
struct Turned {
  double mean, mean_square;
};

/// Moves a speed towards u by one step of the lag: w(t) = u + (w0 - u) exp(-t/tau).
template <class Rotor>
Turned turn(Rotor& r, double u) {
  const double d = r.speed - u;
  const auto& decay = d < 0 ? r.up : r.down;
  r.speed = u + d * decay.end;
  return {u + d * decay.mean, u * u + d * (2 * u * decay.mean + d * decay.mean_square)};
}

}  // namespace

void RotorPlugin::step(const StepInput& input, StepLoad& load) {
  upright_ ? stepUpright(input, load) : stepAnyAxis(input, load);
}

void RotorPlugin::stepAnyAxis(const StepInput& input, StepLoad& load) {
  const double* command = input.command;
  for (Rotor& r : rotors_) {
    const Turned w = turn(r, *command++);
    const Vector3d v = input.v_WC_B + input.w_WB_B.cross(r.hub_C);
    const Vector3d swept = w.mean * (v - r.axis * r.axis.dot(v));  // |w| v_perp
    const Vector3d h_force = -r.drag * swept;
    load.force_B += w.mean_square * r.thrust_force + h_force;
    load.torque_B += w.mean_square * r.thrust_torque + r.hub_C.cross(h_force) - r.rolling * swept;
    load.momentum_mean_B += w.mean * r.momentum;
    load.momentum_end_B += r.speed * r.momentum;
  }
}

/// The same with every axis along z, written out: what is zero then is left out, for this is the
/// inner loop.
void RotorPlugin::stepUpright(const StepInput& input, StepLoad& load) {
  const double vx = input.v_WC_B.x(), vy = input.v_WC_B.y();
  const double wx = input.w_WB_B.x(), wy = input.w_WB_B.y(), wz = input.w_WB_B.z();
  double fx = 0, fy = 0, fz = 0, tx = 0, ty = 0, tz = 0, momentum_mean = 0, momentum_end = 0;
  const double* command = input.command;
  for (Rotor& r : rotors_) {
    const Turned w = turn(r, *command++);
    const double x = r.hub_C.x(), y = r.hub_C.y(), z = r.hub_C.z();
    const double swept_x = w.mean * (vx + wy * z - wz * y);
    const double swept_y = w.mean * (vy + wz * x - wx * z);
    const double hx = -r.drag * swept_x, hy = -r.drag * swept_y;
    fx += hx;
    fy += hy;
    fz += w.mean_square * r.thrust_force.z();
    tx += w.mean_square * r.thrust_torque.x() - z * hy - r.rolling * swept_x;
    ty += w.mean_square * r.thrust_torque.y() + z * hx - r.rolling * swept_y;
    tz += w.mean_square * r.thrust_torque.z() + x * hy - y * hx;
    momentum_mean += w.mean * r.momentum.z();
    momentum_end += r.speed * r.momentum.z();
  }
  load.force_B += Vector3d(fx, fy, fz);
  load.torque_B += Vector3d(tx, ty, tz);
  load.momentum_mean_B.z() += momentum_mean;
  load.momentum_end_B.z() += momentum_end;
}

void RotorPlugin::restore(const VehicleState& state) {
  for (std::size_t i = 0; i < rotors_.size(); ++i) rotors_[i].speed = state.rotor_speed[i];
}

void RotorPlugin::save(VehicleState& state) const {
  state.rotor_speed.resize(rotors_.size());
  for (std::size_t i = 0; i < rotors_.size(); ++i) state.rotor_speed[i] = rotors_[i].speed;
}

void RotorPlugin::archive(StateArchive& archive) {
  for (Rotor& r : rotors_) archive(r.speed);
}

Vector3d RotorPlugin::momentum() const {
  Vector3d sum = Vector3d::Zero();
  for (const Rotor& r : rotors_) sum += r.speed * r.momentum;
  return sum;
}

}  // namespace quad_sim
