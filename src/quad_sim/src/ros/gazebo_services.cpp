#include "gazebo_services.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

GazeboServices::GazeboServices(SimWorld& world, ros::NodeHandle& handle) : world_(world) {
  using Self = GazeboServices;
  servers_ = {
      handle.advertiseService("/gazebo/pause_physics", &Self::onPause, this),
      handle.advertiseService("/gazebo/unpause_physics", &Self::onUnpause, this),
      handle.advertiseService("/gazebo/reset_world", &Self::onResetWorld, this),
      handle.advertiseService("/gazebo/reset_simulation", &Self::onResetSimulation, this),
      handle.advertiseService("/gazebo/get_model_state", &Self::onGetModelState, this),
      handle.advertiseService("/gazebo/set_model_state", &Self::onSetModelState, this),
      handle.advertiseService("/gazebo/get_world_properties", &Self::onGetWorldProperties, this),
      handle.advertiseService("/gazebo/get_physics_properties", &Self::onGetPhysicsProperties,
                              this),
  };
}

bool GazeboServices::onPause(Empty::Request&, Empty::Response&) {
  const WorldGate::Visit visit(world_.gate());
  world_.setRunning(false);
  return true;
}

bool GazeboServices::onUnpause(Empty::Request&, Empty::Response&) {
  const WorldGate::Visit visit(world_.gate());
  world_.setRunning(true);
  return true;
}

bool GazeboServices::onResetWorld(Empty::Request&, Empty::Response&) {
  const WorldGate::Visit visit(world_.gate());
  world_.reset(false);
  return true;
}

bool GazeboServices::onResetSimulation(Empty::Request&, Empty::Response&) {
  const WorldGate::Visit visit(world_.gate());
  world_.reset(true);
  return true;
}

namespace {

bool isWorld(const std::string& frame) {
  return frame.empty() || frame == "world" || frame == "map" || frame == "/map";
}

}  // namespace

bool GazeboServices::onGetModelState(gazebo_msgs::GetModelState::Request& request,
                                     gazebo_msgs::GetModelState::Response& response) {
  if (!world_.isModel(request.model_name) || !isWorld(request.relative_entity_name)) {
    response.status_message =
        fmt::format("no model '{}' relative to '{}'; there is '{}' in the world",
                    request.model_name, request.relative_entity_name, world_.vehicleName());
    return true;
  }
  const WorldGate::Visit visit(world_.gate());
  const Measurement measured = world_.simulator().measure();
  const VehicleState state = world_.simulator().state();
  const nav_msgs::Odometry odometry = toMsg(measured.odometry, "");
  const Eigen::Vector3d w_W = state.q_WB * state.w_WB_B;
  response.header.seq = ++sequence_;
  response.header.stamp = odometry.header.stamp;
  response.header.frame_id = "world";
  response.pose = odometry.pose.pose;
  response.twist.linear.x = state.v_WB.x();
  response.twist.linear.y = state.v_WB.y();
  response.twist.linear.z = state.v_WB.z();
  response.twist.angular.x = w_W.x();
  response.twist.angular.y = w_W.y();
  response.twist.angular.z = w_W.z();
  response.success = true;
  response.status_message = "GetModelState: got properties";
  return true;
}

bool GazeboServices::onSetModelState(gazebo_msgs::SetModelState::Request& request,
                                     gazebo_msgs::SetModelState::Response& response) {
  const gazebo_msgs::ModelState& wanted = request.model_state;
  if (!world_.isModel(wanted.model_name) || !isWorld(wanted.reference_frame)) {
    response.status_message =
        fmt::format("no model '{}' with reference '{}'; there is '{}' in the world",
                    wanted.model_name, wanted.reference_frame, world_.vehicleName());
    return true;
  }
  const WorldGate::Visit visit(world_.gate());
  try {
    nav_msgs::Odometry as_odometry;
    as_odometry.pose.pose = wanted.pose;
    as_odometry.twist.twist = wanted.twist;
    const Odometry given = fromMsg(as_odometry);  // here the twist is in world axes
    VehicleState state = world_.simulator().state();
    state.p_WB = given.p_WB;
    state.q_WB = given.q_WB;
    state.v_WB = given.v_WB_B;
    state.w_WB_B = given.q_WB.normalized().conjugate() * given.w_WB_B;
    world_.simulator().setState(state);
    world_.publish();
    response.success = true;
    response.status_message = "SetModelState: set model state done";
  } catch (const std::invalid_argument& e) {
    response.status_message = e.what();
  }
  return true;
}

bool GazeboServices::onGetWorldProperties(gazebo_msgs::GetWorldProperties::Request&,
                                          gazebo_msgs::GetWorldProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  response.sim_time = static_cast<double>(world_.simulator().timeNanoseconds()) * 1e-9;
  if (world_.config().options.ground) response.model_names.push_back("ground_plane");
  response.model_names.push_back(world_.vehicleName());
  response.rendering_enabled = false;
  response.success = true;
  response.status_message = "GetWorldProperties: got properties";
  return true;
}

bool GazeboServices::onGetPhysicsProperties(gazebo_msgs::GetPhysicsProperties::Request&,
                                            gazebo_msgs::GetPhysicsProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  response.time_step = static_cast<double>(world_.simulator().stepNanoseconds()) * 1e-9;
  response.pause = !world_.running();
  response.max_update_rate = world_.realTimeFactor() / response.time_step;
  response.gravity.z = -world_.config().options.gravity;
  response.success = true;
  response.status_message = "GetPhysicsProperties: got properties";
  return true;
}

}  // namespace quad_sim
