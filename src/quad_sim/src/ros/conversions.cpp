#include "quad_sim_ros/conversions.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

constexpr std::int64_t kSecond = 1000000000;
constexpr char kGroundContact[] = "ground contact at ";

geometry_msgs::Vector3 toMsg(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 out;
  out.x = v.x();
  out.y = v.y();
  out.z = v.z();
  return out;
}

Eigen::Vector3d fromMsg(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

}  // namespace

ros::Time toTime(std::int64_t time_ns) {
  if (time_ns < 0 || time_ns / kSecond > std::numeric_limits<std::uint32_t>::max()) {
    throw std::out_of_range(fmt::format("time {} ns does not fit a ROS stamp", time_ns));
  }
  return ros::Time(static_cast<std::uint32_t>(time_ns / kSecond),
                   static_cast<std::uint32_t>(time_ns % kSecond));
}

ros::Time toStamp(std::int64_t time_ns) { return toTime(time_ns == 0 ? 1 : time_ns); }

std::int64_t toNanoseconds(const ros::Time& time) {
  return static_cast<std::int64_t>(time.sec) * kSecond + time.nsec;
}

std::int64_t simulatedTime(const ros::Time& stamp) {
  const std::int64_t ns = toNanoseconds(stamp);
  return ns == 1 ? 0 : ns;
}

nav_msgs::Odometry toMsg(const Odometry& odometry, const std::string& child_frame) {
  nav_msgs::Odometry out;
  out.header.stamp = toStamp(odometry.time_ns);
  out.header.frame_id = "world";
  out.child_frame_id = child_frame;
  out.pose.pose.position.x = odometry.p_WB.x();
  out.pose.pose.position.y = odometry.p_WB.y();
  out.pose.pose.position.z = odometry.p_WB.z();
  out.pose.pose.orientation.w = odometry.q_WB.w();
  out.pose.pose.orientation.x = odometry.q_WB.x();
  out.pose.pose.orientation.y = odometry.q_WB.y();
  out.pose.pose.orientation.z = odometry.q_WB.z();
  out.twist.twist.linear = toMsg(odometry.v_WB_B);
  out.twist.twist.angular = toMsg(odometry.w_WB_B);
  return out;
}

Odometry fromMsg(const nav_msgs::Odometry& message) {
  Odometry out;
  out.time_ns = simulatedTime(message.header.stamp);
  const auto& p = message.pose.pose.position;
  const auto& q = message.pose.pose.orientation;
  out.p_WB = Eigen::Vector3d(p.x, p.y, p.z);
  out.q_WB = Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  out.v_WB_B = fromMsg(message.twist.twist.linear);
  out.w_WB_B = fromMsg(message.twist.twist.angular);
  return out;
}

mav_msgs::Actuators toMsg(const std::vector<double>& rotor_speed, const VehicleModel& model,
                          std::int64_t time_ns, const std::string& frame) {
  mav_msgs::Actuators out;
  out.header.stamp = toStamp(time_ns);
  out.header.frame_id = frame;
  out.angular_velocities.resize(rotor_speed.size());
  for (std::size_t i = 0; i < rotor_speed.size(); ++i) {
    out.angular_velocities[i] = model.rotors[i].spin * rotor_speed[i];
  }
  return out;
}

std::vector<double> rotorSpeeds(const mav_msgs::Actuators& message, const VehicleModel& model) {
  if (message.angular_velocities.size() != model.rotors.size()) {
    throw quad_support::DataError(
        fmt::format("motor_speed: {} angular velocities; the vehicle has {} rotors",
                    message.angular_velocities.size(), model.rotors.size()));
  }
  std::vector<double> out = message.angular_velocities;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] *= model.rotors[i].spin;
  return out;
}

std::string groundContactMessage(const std::optional<std::int64_t>& time_ns) {
  if (!time_ns) return "";
  return kGroundContact + quad_support::shortest(static_cast<double>(*time_ns) * 1e-9) + " s";
}

std::optional<std::int64_t> groundContactTime(const std::string& message) {
  const std::string prefix = kGroundContact;
  if (message.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
  return std::llround(std::strtod(message.c_str() + prefix.size(), nullptr) * 1e9);
}

geometry_msgs::TransformStamped toTransform(const nav_msgs::Odometry& odometry) {
  geometry_msgs::TransformStamped out;
  out.header = odometry.header;
  out.child_frame_id = odometry.child_frame_id;
  out.transform.translation.x = odometry.pose.pose.position.x;
  out.transform.translation.y = odometry.pose.pose.position.y;
  out.transform.translation.z = odometry.pose.pose.position.z;
  out.transform.rotation = odometry.pose.pose.orientation;
  return out;
}

}  // namespace quad_sim
