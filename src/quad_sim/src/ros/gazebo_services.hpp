/// The services of Gazebo's ROS interface that act on the world: pausing, resetting, properties.
#pragma once

#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/SetPhysicsProperties.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include <vector>

#include "sim_world.hpp"

namespace quad_sim {

/// /gazebo/pause_physics and its siblings. Like Gazebo's, a call that cannot be fulfilled succeeds
/// and says success: false.
class GazeboServices {
 public:
  GazeboServices(SimWorld& world, ros::NodeHandle& handle);

 private:
  using Empty = std_srvs::Empty;
  bool onPause(Empty::Request&, Empty::Response&);
  bool onUnpause(Empty::Request&, Empty::Response&);
  bool onResetWorld(Empty::Request&, Empty::Response&);
  bool onResetSimulation(Empty::Request&, Empty::Response&);
  bool onGetWorldProperties(gazebo_msgs::GetWorldProperties::Request&,
                            gazebo_msgs::GetWorldProperties::Response&);
  bool onGetPhysicsProperties(gazebo_msgs::GetPhysicsProperties::Request&,
                              gazebo_msgs::GetPhysicsProperties::Response&);
  bool onSetPhysicsProperties(gazebo_msgs::SetPhysicsProperties::Request&,
                              gazebo_msgs::SetPhysicsProperties::Response&);

  SimWorld& world_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace quad_sim
