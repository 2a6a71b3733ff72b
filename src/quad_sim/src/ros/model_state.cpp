#include "model_state.hpp"

#include <stdexcept>

namespace quad_sim {
namespace {

template <class Message>
void fill(const Eigen::Vector3d& v, Message& out) {
  out.x = v.x();
  out.y = v.y();
  out.z = v.z();
}

}  // namespace

ModelState modelState(const VehicleState& s) { return {s.p_WB, s.q_WB, s.v_WB, s.q_WB * s.w_WB_B}; }

ModelState relativeTo(const ModelState& other, const ModelState& state) {
  const Eigen::Quaterniond back = other.attitude.conjugate();
  return {back * (state.position - other.position), back * state.attitude,
          back * (state.velocity - other.velocity), back * (state.rate - other.rate)};
}

ModelState fromFrame(const ModelState& frame, const ModelState& given) {
  const Eigen::Quaterniond& q = frame.attitude;
  return {frame.position + q * given.position, q * given.attitude, q * given.velocity,
          q * given.rate};
}

VehicleState moved(VehicleState state, const ModelState& to) {
  state.p_WB = to.position;
  state.q_WB = to.attitude;
  state.v_WB = to.velocity;
  state.w_WB_B = to.attitude.conjugate() * to.rate;
  return state;
}

ModelState linkState(const VehicleState& vehicle, const LinkModel& link) {
  return linkState(vehicle, link, Eigen::Vector3d::UnitZ(), 0, 0);
}

ModelState linkState(const VehicleState& vehicle, const LinkModel& link,
                     const Eigen::Vector3d& axis_B, double angle, double speed) {
  const Eigen::Quaterniond& q = vehicle.q_WB;
  const Eigen::Vector3d& r_B = link.X_BL.translation();
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(angle, axis_B) * link.X_BL.linear());
  return {vehicle.p_WB + q * r_B, q * turned, vehicle.v_WB + q * vehicle.w_WB_B.cross(r_B),
          q * (vehicle.w_WB_B + speed * axis_B)};
}

geometry_msgs::Pose poseMsg(const ModelState& state) {
  geometry_msgs::Pose out;
  fill(state.position, out.position);
  out.orientation.w = state.attitude.w();
  out.orientation.x = state.attitude.x();
  out.orientation.y = state.attitude.y();
  out.orientation.z = state.attitude.z();
  return out;
}

geometry_msgs::Twist twistMsg(const ModelState& state) {
  geometry_msgs::Twist out;
  fill(state.velocity, out.linear);
  fill(state.rate, out.angular);
  return out;
}

geometry_msgs::Wrench wrenchMsg(const Wrench& wrench) {
  geometry_msgs::Wrench out;
  fill(wrench.force, out.force);
  fill(wrench.torque, out.torque);
  return out;
}

ModelState modelState(const geometry_msgs::Pose& pose, const geometry_msgs::Twist& twist) {
  ModelState out;
  out.position = {pose.position.x, pose.position.y, pose.position.z};
  out.attitude = {pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z};
  out.velocity = {twist.linear.x, twist.linear.y, twist.linear.z};
  out.rate = {twist.angular.x, twist.angular.y, twist.angular.z};
  const bool finite = out.position.allFinite() && out.attitude.coeffs().allFinite() &&
                      out.velocity.allFinite() && out.rate.allFinite();
  if (!finite) throw std::invalid_argument("every number of pose and twist must be finite");
  if (!(out.attitude.norm() > 1e-6))
    throw std::invalid_argument("the orientation must not be zero");
  out.attitude.normalize();
  return out;
}

}  // namespace quad_sim
