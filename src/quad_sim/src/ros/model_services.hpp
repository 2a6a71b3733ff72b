/// The services of Gazebo's ROS interface that act on one vehicle, and what this simulator adds to
/// them.
#pragma once

#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/SetModelState.h>
#include <quad_sim/CommandReport.h>
#include <quad_sim/RestoreState.h>
#include <quad_sim/SaveState.h>
#include <ros/ros.h>

#include <map>
#include <string>
#include <vector>

#include "model_state.hpp"
#include "sim_world.hpp"

namespace quad_sim {

/// get_model_state, set_model_state (service and topic), command_report; save_state and
/// restore_state of the whole world.
class ModelServices {
 public:
  ModelServices(SimWorld& world, ros::NodeHandle& handle);

 private:
  bool onGetModelState(gazebo_msgs::GetModelState::Request&, gazebo_msgs::GetModelState::Response&);
  bool onSetModelState(gazebo_msgs::SetModelState::Request&, gazebo_msgs::SetModelState::Response&);
  void onModelState(const gazebo_msgs::ModelState& wanted);
  bool onCommandReport(CommandReport::Request&, CommandReport::Response&);
  bool onSaveState(SaveState::Request&, SaveState::Response&);
  bool onRestoreState(RestoreState::Request&, RestoreState::Response&);

  std::string set(
      const gazebo_msgs::ModelState& wanted);  ///< what went wrong; empty if nothing did

  SimWorld& world_;
  std::map<std::string, unsigned> sequence_;  ///< of get_model_state's answers, by model
  std::vector<ros::ServiceServer> servers_;
  ros::Subscriber model_state_sub_;
};

}  // namespace quad_sim
