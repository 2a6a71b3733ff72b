/// The services of Gazebo's ROS interface that act on links: their state, and wrenches on them.
#pragma once

#include <gazebo_msgs/ApplyBodyWrench.h>
#include <gazebo_msgs/BodyRequest.h>
#include <gazebo_msgs/GetLinkState.h>
#include <gazebo_msgs/SetLinkState.h>
#include <ros/ros.h>

#include <string>
#include <vector>

#include "sim_world.hpp"

namespace quad_sim {

/// get_link_state, set_link_state (service and topic), apply_body_wrench, clear_body_wrenches.
///
/// A vehicle is one body to them: a wrench acts on it through any link fixed to base_link, and a
/// link is set by moving the vehicle.
class LinkServices {
 public:
  LinkServices(SimWorld& world, ros::NodeHandle& handle);

 private:
  bool onGet(gazebo_msgs::GetLinkState::Request&, gazebo_msgs::GetLinkState::Response&);
  bool onSet(gazebo_msgs::SetLinkState::Request&, gazebo_msgs::SetLinkState::Response&);
  void onLinkState(const gazebo_msgs::LinkState& wanted);
  bool onApply(gazebo_msgs::ApplyBodyWrench::Request&, gazebo_msgs::ApplyBodyWrench::Response&);
  bool onClear(gazebo_msgs::BodyRequest::Request&, gazebo_msgs::BodyRequest::Response&);

  /// What went wrong; empty if nothing did.
  std::string get(const gazebo_msgs::GetLinkState::Request& request, gazebo_msgs::LinkState& out);
  std::string set(const gazebo_msgs::LinkState& wanted);
  std::string apply(const gazebo_msgs::ApplyBodyWrench::Request& request);

  SimWorld& world_;
  std::vector<ros::ServiceServer> servers_;
  ros::Subscriber link_state_sub_;
};

}  // namespace quad_sim
