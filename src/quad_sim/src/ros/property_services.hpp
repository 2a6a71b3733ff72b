/// What Gazebo's ROS interface tells of models, links and joints that does not change in flight.
#pragma once

#include <gazebo_msgs/GetJointProperties.h>
#include <gazebo_msgs/GetLinkProperties.h>
#include <gazebo_msgs/GetModelProperties.h>
#include <ros/ros.h>

#include <vector>

#include "sim_world.hpp"

namespace quad_sim {

/// get_model_properties, get_link_properties, get_joint_properties (the latter with the joint's
/// angle and speed). To set them, change the URDF.
class PropertyServices {
 public:
  PropertyServices(SimWorld& world, ros::NodeHandle& handle);

 private:
  bool onModel(gazebo_msgs::GetModelProperties::Request&,
               gazebo_msgs::GetModelProperties::Response&);
  bool onLink(gazebo_msgs::GetLinkProperties::Request&, gazebo_msgs::GetLinkProperties::Response&);
  bool onJoint(gazebo_msgs::GetJointProperties::Request&,
               gazebo_msgs::GetJointProperties::Response&);

  SimWorld& world_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace quad_sim
