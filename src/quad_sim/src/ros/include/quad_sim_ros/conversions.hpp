/// Between the library's types and ROS messages. Free functions, so that a test can go there and
/// back.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quad_sim/state.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

/// Simulated time [ns] as a message's stamp. ROS reads a stamp of zero as "unset", so time 0
/// becomes 1 ns; every other time is exact. @throws std::out_of_range beyond what a stamp holds
/// (136 years)
ros::Time toStamp(std::int64_t time_ns);
/// The same without the exception for zero.
ros::Time toTime(std::int64_t time_ns);
std::int64_t toNanoseconds(const ros::Time& time);
/// Simulated time [ns] of a message's stamp, the inverse of toStamp(): 1 ns is 0 again.
std::int64_t simulatedTime(const ros::Time& stamp);

/// Pose in `world`, twist in body axes, covariances zero (the sensor is ideal).
nav_msgs::Odometry toMsg(const Odometry& odometry, const std::string& child_frame);
/// A stamp of 1 ns gives time 0, the inverse of toMsg().
Odometry fromMsg(const nav_msgs::Odometry& message);

/// True rotor speeds, signed by the turning direction (negative: clockwise), as RotorS publishes
/// them.
mav_msgs::Actuators toMsg(const std::vector<double>& rotor_speed, const VehicleModel& model,
                          std::int64_t time_ns, const std::string& frame);
/// Unsigned speeds by motor number. @throws quad_support::DataError if the number of speeds is not
/// that of the rotors
std::vector<double> rotorSpeeds(const mav_msgs::Actuators& message, const VehicleModel& model);

/// What Step's `message` says of the first ground contact [ns], and back; empty where there was
/// none.
std::string groundContactMessage(const std::optional<std::int64_t>& time_ns);
std::optional<std::int64_t> groundContactTime(const std::string& message);

geometry_msgs::TransformStamped toTransform(const nav_msgs::Odometry& odometry);

}  // namespace quad_sim
