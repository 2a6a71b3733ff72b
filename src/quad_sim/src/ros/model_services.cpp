#include "model_services.hpp"

#include <stdexcept>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

ModelServices::ModelServices(SimWorld& world, ros::NodeHandle& handle) : world_(world) {
  using Self = ModelServices;
  servers_ = {
      handle.advertiseService("/gazebo/get_model_state", &Self::onGetModelState, this),
      handle.advertiseService("/gazebo/set_model_state", &Self::onSetModelState, this),
      handle.advertiseService("/gazebo/command_report", &Self::onCommandReport, this),
      handle.advertiseService("/gazebo/save_state", &Self::onSaveState, this),
      handle.advertiseService("/gazebo/restore_state", &Self::onRestoreState, this),
  };
  model_state_sub_ = handle.subscribe("/gazebo/set_model_state", 10, &Self::onModelState, this);
}

bool ModelServices::onGetModelState(gazebo_msgs::GetModelState::Request& request,
                                    gazebo_msgs::GetModelState::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  Vehicle* const vehicle = world_.find(request.model_name);
  Vehicle* const other = world_.find(request.relative_entity_name);
  if (!vehicle || (!other && !isWorld(request.relative_entity_name))) {
    response.status_message =
        "GetModelState: " +
        world_.nobody(vehicle ? request.relative_entity_name : request.model_name);
    return true;
  }
  ModelState state = modelState(vehicle->simulator.state());
  if (other) state = relativeTo(modelState(other->simulator.state()), state);
  response.header.seq = ++sequence_[vehicle->name];
  response.header.stamp = toStamp(world_.timeNanoseconds());
  response.header.frame_id = other ? request.relative_entity_name : "world";
  response.pose = poseMsg(state);
  response.twist = twistMsg(state);
  response.success = true;
  response.status_message = "GetModelState: got properties";
  return true;
}

std::string ModelServices::set(const gazebo_msgs::ModelState& wanted) {
  const WorldGate::Visit visit(world_.gate());
  Vehicle* const vehicle = world_.find(wanted.model_name);
  Vehicle* const frame = world_.find(wanted.reference_frame);
  if (!vehicle || (!frame && !isWorld(wanted.reference_frame))) {
    return world_.nobody(vehicle ? wanted.reference_frame : wanted.model_name);
  }
  try {
    ModelState given = modelState(wanted.pose, wanted.twist);
    if (frame) given = fromFrame(modelState(frame->simulator.state()), given);
    vehicle->simulator.setState(moved(vehicle->simulator.state(), given));
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  world_.publish();
  return "";
}

bool ModelServices::onSetModelState(gazebo_msgs::SetModelState::Request& request,
                                    gazebo_msgs::SetModelState::Response& response) {
  const std::string problem = set(request.model_state);
  response.success = problem.empty();
  response.status_message =
      "SetModelState: " + (problem.empty() ? "set model state done" : problem);
  return true;
}

void ModelServices::onModelState(const gazebo_msgs::ModelState& wanted) {
  const std::string problem = set(wanted);
  if (!problem.empty()) ROS_ERROR("/gazebo/set_model_state: %s", problem.c_str());
}

bool ModelServices::onCommandReport(CommandReport::Request& request,
                                    CommandReport::Response& response) {
  Vehicle* const vehicle =
      request.model_name.empty() ? &world_.first() : world_.find(request.model_name);
  if (!vehicle) {
    response.message = world_.nobody(request.model_name);
    return true;
  }
  const CommandTally tally = vehicle->commands.tally();
  response.received = tally.received;
  response.wrong_length = tally.wrong_length;
  response.not_finite = tally.not_finite;
  response.late = tally.late;
  response.negative = tally.negative;
  response.over_limit = tally.over_limit;
  response.last_problem = tally.last_problem;
  response.success = true;
  return true;
}

bool ModelServices::onSaveState(SaveState::Request&, SaveState::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  response.state = world_.save();
  response.success = true;
  return true;
}

bool ModelServices::onRestoreState(RestoreState::Request& request,
                                   RestoreState::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  try {
    world_.restore(request.state);
    response.success = true;
  } catch (const std::invalid_argument& e) {
    response.message = e.what();
  }
  return true;
}

}  // namespace quad_sim
