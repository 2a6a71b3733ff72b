/// What one vehicle says over ROS.
#pragma once

#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <string>
#include <utility>
#include <vector>

#include "quad_sim/simulator.hpp"

namespace quad_sim {

/// Publishes a simulator's present state on the topics below the vehicle's namespace.
class VehicleTopics {
 public:
  /// @param name  the vehicle's namespace, without slashes at its ends
  /// @throws std::invalid_argument if the vehicle has no odometry sensor
  VehicleTopics(const Simulator& simulator, const std::string& name, const ros::NodeHandle& handle);

  void publish();
  const nav_msgs::Odometry& odometry() const { return last_odometry_; }  ///< published last
  const mav_msgs::Actuators& motorSpeed() const {
    return last_motor_speed_;
  }  ///< of the same instant

 private:
  void publishOthers(const Measurement& measured);

  const Simulator& simulator_;
  std::string name_;
  const SensorModel* primary_ =
      nullptr;  ///< the odometry sensor controllers listen to: the URDF's first
  nav_msgs::Odometry last_odometry_;
  mav_msgs::Actuators last_motor_speed_;
  ros::Publisher odometry_pub_, motor_speed_pub_, relay_pub_, tf_pub_;
  std::vector<std::pair<const SensorModel*, ros::Publisher>> other_odometry_;
  std::vector<ros::Publisher> rotor_pubs_;
};

}  // namespace quad_sim
