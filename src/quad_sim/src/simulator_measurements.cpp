// What can be seen of a simulator, without changing it.
#include <cmath>

#include "quad_sim/simulator.hpp"
#include "simulator_world.hpp"

namespace quad_sim {

using Eigen::Vector3d;

VehicleState Simulator::state() const {
  VehicleState state;
  world_->body->save(state);
  for (const auto& plugin : world_->plugins) plugin->save(state);
  return state;
}

void Simulator::measure(Measurement& out) const {
  VehicleState state;
  state.rotor_speed.swap(out.rotor_speed);
  world_->body->save(state);
  for (const auto& plugin : world_->plugins) plugin->save(state);
  out.rotor_speed.swap(state.rotor_speed);
  // RotorS samples at the start of a step whose time it has advanced already.
  out.odometry.time_ns =
      timeNanoseconds() + (world_->settings.quirks.stamp_ahead ? stepNanoseconds() : 0);
  out.odometry.p_WB = state.p_WB;
  out.odometry.q_WB = state.q_WB;
  out.odometry.v_WB_B = state.q_WB.conjugate() * state.v_WB;
  out.odometry.w_WB_B = state.w_WB_B;
  out.ground_contact_ns = groundContactTime();
}

Measurement Simulator::measure() const {
  Measurement measurement;
  measure(measurement);
  return measurement;
}

Odometry Simulator::odometry(const SensorModel& sensor) const {
  Odometry at = measure().odometry;
  if (sensor.X_BS.isApprox(Eigen::Isometry3d::Identity(), 0.0))
    return at;  // the very bits of measure()
  const Vector3d r_B = sensor.X_BS.translation();
  const Eigen::Quaterniond q_BS(sensor.X_BS.linear());
  at.p_WB += at.q_WB * r_B;
  at.v_WB_B = q_BS.conjugate() * (at.v_WB_B + at.w_WB_B.cross(r_B));
  at.w_WB_B = q_BS.conjugate() * at.w_WB_B;
  at.q_WB = (at.q_WB * q_BS).normalized();
  return at;
}

Vector3d Simulator::specificForce(const SensorModel& sensor) const {
  const Vector3d r_C = sensor.X_BS.translation() - world_->model.com_B;
  return sensor.X_BS.linear().transpose() * world_->body->specificForce(r_C);
}

Wrench Simulator::groundLoad() const {
  return world_->on_ground ? world_->body->groundLoad() : Wrench{};
}

Vector3d Simulator::outsideForce() const {
  Vector3d sum = Vector3d::Zero();
  for (const auto& plugin : world_->plugins) sum += plugin->outsideForce();
  return sum;
}

std::vector<RotorState> Simulator::rotorStates() const { return world_->body->rotors(); }

std::vector<int> Simulator::aliasedRotors() const {
  const VehicleState now = state();
  const World& w = *world_;
  std::vector<int> numbers;
  for (const RotorModel& rotor : w.model.rotors) {
    const double speed = now.rotor_speed[static_cast<std::size_t>(rotor.motor_number)];
    const double seen =
        w.settings.quirks.aliasing_blind ? rotor.spin * speed / rotor.slowdown : std::abs(speed);
    constexpr double kHalfTurn = 3.141592653589793;  // [rad]
    if (seen * w.settings.step > kHalfTurn) numbers.push_back(rotor.motor_number);
  }
  return numbers;
}

Vector3d Simulator::wind() const { return world_->wind; }

ImuReading Simulator::imu(const SensorModel& sensor) const {
  const Odometry at = odometry(sensor);
  return {at.time_ns, at.q_WB, at.w_WB_B, specificForce(sensor)};
}

bool Simulator::groundContact() const { return world_->contact_step >= 0; }

std::optional<std::int64_t> Simulator::groundContactTime() const {
  if (!groundContact()) return std::nullopt;
  return world_->contact_step * world_->step_ns;
}

}  // namespace quad_sim
