/// ROS messages to and from the library's types.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/WrenchStamped.h>
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <cstdint>
#include <string>
#include <vector>

#include "quad_control/FlightRecord.h"
#include "quad_control/SetFlightPlan.h"
#include "quad_control/control_config.hpp"
#include "quad_control/flight_controller.hpp"
#include "quad_control/references.hpp"
#include "quad_sim_ros/conversions.hpp"

namespace quad_control {

/// Position and heading of a pose; the heading is that of its z-y'-x'' angles.
References fromMsg(const geometry_msgs::Pose& pose);

/// The positions and headings of a trajectory's points, each from its time_from_start on;
/// velocities and accelerations are not used. @throws quad_support::ConfigError for a point without
/// transform and as ReferenceTrajectory
ReferenceTrajectory fromMsg(const trajectory_msgs::MultiDOFJointTrajectory& message);
trajectory_msgs::MultiDOFJointTrajectory toMsg(const std::vector<Waypoint>& waypoints);

/// @param gravity  g of the configuration [m/s²]
FlightPlan fromMsg(const SetFlightPlan::Request& request, double gravity);

/// Rotor speeds for the topic command/motor_speed; `stamp` is the odometry's, copied as it is.
mav_msgs::Actuators toMsg(const std::vector<double>& rotor_speed, const ros::Time& stamp);

/// U as a wrench in the body frame: force.z is the thrust, torque the three torques.
geometry_msgs::WrenchStamped toMsg(const ControlInput& input, const ros::Time& stamp,
                                   const std::string& frame);

void toMsg(const std::vector<ControlOutput>& record, FlightRecord::Response& response);

/// What both nodes read from their one parameter, ~config: the path of the experiment's YAML file.
struct NodeConfig {
  quad_sim::VehicleModel vehicle;
  double gravity = 0.0;  ///< [m/s²]
  double step = 0.0;     ///< physics step [s]
  ControlConfig control;
  TimingConfig timing;
};

/// @throws std::invalid_argument (ConfigError with file and line) for a missing parameter or a
/// wrong value
NodeConfig readNodeConfig();

}  // namespace quad_control
