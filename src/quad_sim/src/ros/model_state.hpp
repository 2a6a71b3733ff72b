/// A vehicle's state as Gazebo tells it: pose and twist of base_link's origin, both in one frame's
/// axes.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/Wrench.h>

#include <Eigen/Geometry>

#include "quad_sim/state.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

struct ModelState {
  Eigen::Vector3d position;
  Eigen::Quaterniond attitude;
  Eigen::Vector3d velocity, rate;  ///< in the frame's axes, unlike an odometry's twist
};

ModelState modelState(const VehicleState& state);  ///< in the world
/// `state` as seen from another vehicle: relative pose, velocities less the other's, in the other's
/// axes.
ModelState relativeTo(const ModelState& other, const ModelState& state);
/// A pose and twist given in the axes and from the place of `frame`, in the world. The frame's own
/// motion is not added: so does Gazebo.
ModelState fromFrame(const ModelState& frame, const ModelState& given);
/// `state` moved to that pose and twist; rotors as they are.
VehicleState moved(VehicleState state, const ModelState& to);

/// A link fixed to base_link, in the world: its origin and axes.
ModelState linkState(const VehicleState& vehicle, const LinkModel& link);

/// The same of a link that turns about `axis_B` (through its origin) by `angle` [rad] with `speed`
/// [rad/s].
ModelState linkState(const VehicleState& vehicle, const LinkModel& link,
                     const Eigen::Vector3d& axis_B, double angle, double speed);

geometry_msgs::Pose poseMsg(const ModelState& state);
geometry_msgs::Twist twistMsg(const ModelState& state);
geometry_msgs::Wrench wrenchMsg(const Wrench& wrench);
/// @throws std::invalid_argument for a quaternion of zero length or numbers that are not finite
ModelState modelState(const geometry_msgs::Pose& pose, const geometry_msgs::Twist& twist);

}  // namespace quad_sim
