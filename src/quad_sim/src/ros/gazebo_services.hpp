/// The services of Gazebo's ROS interface that this simulator has.
#pragma once

#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/SetModelState.h>
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
  bool onGetModelState(gazebo_msgs::GetModelState::Request&, gazebo_msgs::GetModelState::Response&);
  bool onSetModelState(gazebo_msgs::SetModelState::Request&, gazebo_msgs::SetModelState::Response&);
  bool onGetWorldProperties(gazebo_msgs::GetWorldProperties::Request&,
                            gazebo_msgs::GetWorldProperties::Response&);
  bool onGetPhysicsProperties(gazebo_msgs::GetPhysicsProperties::Request&,
                              gazebo_msgs::GetPhysicsProperties::Response&);

  SimWorld& world_;
  unsigned sequence_ = 0;  ///< of get_model_state's answers
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace quad_sim
