#include "conversions.hpp"

#include <ros/param.h>
#include <ros/this_node.h>

#include <cmath>
#include <stdexcept>

#include "quad_sim/simulation_config.hpp"
#include "quad_support/config_reader.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {

References fromMsg(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  return {pose.position.x, pose.position.y, pose.position.z,
          rollPitchYaw(Eigen::Quaterniond(q.w, q.x, q.y, q.z)).z()};
}

ReferenceTrajectory fromMsg(const trajectory_msgs::MultiDOFJointTrajectory& message) {
  std::vector<Waypoint> waypoints;
  for (const auto& point : message.points) {
    if (point.transforms.empty())
      throw quad_support::ConfigError("trajectory: a point without transform");
    geometry_msgs::Pose pose;
    pose.position.x = point.transforms[0].translation.x;
    pose.position.y = point.transforms[0].translation.y;
    pose.position.z = point.transforms[0].translation.z;
    pose.orientation = point.transforms[0].rotation;
    waypoints.push_back({point.time_from_start.toNSec(), fromMsg(pose)});
  }
  return ReferenceTrajectory(std::move(waypoints));
}

trajectory_msgs::MultiDOFJointTrajectory toMsg(const std::vector<Waypoint>& waypoints) {
  trajectory_msgs::MultiDOFJointTrajectory message;
  message.joint_names = {"base_link"};
  for (const Waypoint& waypoint : waypoints) {
    const References& r = waypoint.references;
    trajectory_msgs::MultiDOFJointTrajectoryPoint point;
    point.time_from_start.fromNSec(waypoint.from_start_ns);
    point.transforms.resize(1);
    point.transforms[0].translation.x = r.x;
    point.transforms[0].translation.y = r.y;
    point.transforms[0].translation.z = r.z;
    point.transforms[0].rotation.w = std::cos(r.yaw / 2);
    point.transforms[0].rotation.z = std::sin(r.yaw / 2);
    message.points.push_back(point);
  }
  return message;
}

FlightPlan fromMsg(const SetFlightPlan::Request& request, double gravity) {
  FlightPlan plan;
  plan.references = {request.x, request.y, request.z, request.yaw};
  plan.feed_forward_mass = request.feed_forward_mass;
  plan.gravity = gravity;
  plan.initial_altitude_effort = request.initial_altitude_effort;
  plan.exploration_start_ns = quad_sim::simulatedTime(request.exploration_start);
  plan.exploration_signal = request.exploration_signal;
  // "empty: the hold goes on for ever", whatever the start stamp says.
  if (plan.exploration_signal.empty())
    plan.exploration_start_ns = FlightPlan().exploration_start_ns;
  return plan;
}

mav_msgs::Actuators toMsg(const std::vector<double>& rotor_speed, const ros::Time& stamp) {
  mav_msgs::Actuators msg;
  msg.header.stamp = stamp;
  msg.angular_velocities = rotor_speed;
  return msg;
}

geometry_msgs::WrenchStamped toMsg(const ControlInput& input, const ros::Time& stamp,
                                   const std::string& frame) {
  geometry_msgs::WrenchStamped msg;
  msg.header.stamp = stamp;
  msg.header.frame_id = frame;
  msg.wrench.force.z = input(0);
  msg.wrench.torque.x = input(1);
  msg.wrench.torque.y = input(2);
  msg.wrench.torque.z = input(3);
  return msg;
}

void toMsg(const std::vector<ControlOutput>& record, FlightRecord::Response& response) {
  for (const ControlOutput& out : record) {
    response.time.push_back(quad_sim::toStamp(out.time_ns));
    response.thrust.push_back(out.thrust);
    response.tau_phi.push_back(out.tau_phi);
    response.tau_theta.push_back(out.tau_theta);
    response.tau_psi.push_back(out.tau_psi);
    response.t_eff.push_back(out.t_eff);
    response.clamped.push_back(static_cast<std::uint32_t>(out.clamped));
  }
}

NodeConfig readNodeConfig() {
  std::string path;
  if (!ros::param::get("~config", path)) {
    throw std::invalid_argument(
        "parameter " + ros::this_node::getName() +
        "/config is missing; set it to the path of the experiment's YAML file");
  }
  const auto file = quad_support::ConfigReader::fromFile(path);
  const quad_sim::SimulationConfig simulation = quad_sim::readSimulationConfig(path);
  NodeConfig config;
  config.vehicle = simulation.model;
  config.gravity = simulation.options.gravity;
  config.step = simulation.options.step;
  config.timing = readTimingConfig(file.section("timing"), config.step);
  config.control = readControlConfig(file.section("control"), config.timing.sampling_period);
  return config;
}

}  // namespace quad_control
