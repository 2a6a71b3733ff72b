#include "gazebo_services.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "quad_support/number_format.hpp"

namespace quad_sim {

using quad_support::shortest;

GazeboServices::GazeboServices(SimWorld& world, ros::NodeHandle& handle) : world_(world) {
  using Self = GazeboServices;
  servers_ = {
      handle.advertiseService("/gazebo/pause_physics", &Self::onPause, this),
      handle.advertiseService("/gazebo/unpause_physics", &Self::onUnpause, this),
      handle.advertiseService("/gazebo/reset_world", &Self::onResetWorld, this),
      handle.advertiseService("/gazebo/reset_simulation", &Self::onResetSimulation, this),
      handle.advertiseService("/gazebo/get_world_properties", &Self::onGetWorldProperties, this),
      handle.advertiseService("/gazebo/get_physics_properties", &Self::onGetPhysicsProperties,
                              this),
      handle.advertiseService("/gazebo/set_physics_properties", &Self::onSetPhysicsProperties,
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

bool GazeboServices::onGetWorldProperties(gazebo_msgs::GetWorldProperties::Request&,
                                          gazebo_msgs::GetWorldProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  response.sim_time = static_cast<double>(world_.timeNanoseconds()) * 1e-9;
  if (world_.ground()) response.model_names.push_back("ground_plane");
  for (const auto& vehicle : world_.vehicles()) response.model_names.push_back(vehicle->name);
  response.rendering_enabled = false;
  response.success = true;
  response.status_message = "GetWorldProperties: got properties";
  return true;
}

bool GazeboServices::onGetPhysicsProperties(gazebo_msgs::GetPhysicsProperties::Request&,
                                            gazebo_msgs::GetPhysicsProperties::Response& response) {
  const WorldGate::Visit visit(world_.gate());
  response.time_step = world_.step();
  response.pause = !world_.running();
  response.max_update_rate = world_.realTimeFactor() / world_.step();
  response.gravity.z = -world_.gravity();
  response.success = true;
  response.status_message = "GetPhysicsProperties: got properties";
  return true;
}

namespace {

/// What of a request this simulator cannot do; empty if nothing. The settings of ODE's solver are
/// not among it: ours needs none.
std::string impossible(const gazebo_msgs::SetPhysicsProperties::Request& request) {
  const auto& g = request.gravity;
  if (g.x != 0 || g.y != 0 || !(g.z <= 0)) {
    return fmt::format("gravity = ({}, {}, {}) m/s^2; must be (0, 0, <= 0)", shortest(g.x),
                       shortest(g.y), shortest(g.z));
  }
  if (!(request.max_update_rate >= 0) || std::isinf(request.max_update_rate)) {
    return fmt::format("max_update_rate = {} Hz; must be >= 0 (0: as fast as possible)",
                       shortest(request.max_update_rate));
  }
  return "";
}

}  // namespace

bool GazeboServices::onSetPhysicsProperties(gazebo_msgs::SetPhysicsProperties::Request& request,
                                            gazebo_msgs::SetPhysicsProperties::Response& response) {
  response.status_message = impossible(request);
  if (!response.status_message.empty()) return true;
  const WorldGate::Visit visit(world_.gate());
  try {
    world_.setPhysics(request.time_step, -request.gravity.z,
                      request.max_update_rate * request.time_step);
    world_.publish();
    response.success = true;
    response.status_message = "physics engine updated";
  } catch (const std::invalid_argument& e) {
    response.status_message = e.what();
  }
  return true;
}

}  // namespace quad_sim
