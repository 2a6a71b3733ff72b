#include "spawn_services.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "quad_support/number_format.hpp"

namespace quad_sim {

SpawnServices::SpawnServices(SimWorld& world, ros::NodeHandle& handle) : world_(world) {
  using Self = SpawnServices;
  servers_ = {
      handle.advertiseService("/gazebo/spawn_urdf_model", &Self::onSpawn, this),
      handle.advertiseService("/gazebo/spawn_sdf_model", &Self::onSpawnSdf, this),
      handle.advertiseService("/gazebo/delete_model", &Self::onDelete, this),
  };
}

namespace {

/// What is wrong with the name of a new vehicle, which is its namespace too; empty if nothing is.
std::string nameProblem(const gazebo_msgs::SpawnModel::Request& request) {
  std::string why;
  const std::string& name = request.model_name;
  if (name.empty() || name.front() == '/' || !ros::names::validate(name, why)) {
    return fmt::format(
        "model_name '{}' must be a ROS name without leading slash, for it is the namespace too",
        name);
  }
  std::string ns = request.robot_namespace;
  while (!ns.empty() && ns.front() == '/') ns.erase(0, 1);
  while (!ns.empty() && ns.back() == '/') ns.pop_back();
  if (ns.empty() || ns == name) return "";
  return fmt::format("robot_namespace '{}' must be empty or the model_name '{}'",
                     request.robot_namespace, name);
}

}  // namespace

std::string SpawnServices::spawn(const Spawn::Request& request) {
  const std::string problem = nameProblem(request);
  if (!problem.empty()) return problem;
  const WorldGate::Visit visit(world_.gate());
  Vehicle* const frame = world_.find(request.reference_frame);
  if (!frame && !isWorld(request.reference_frame)) return world_.nobody(request.reference_frame);
  for (const auto& vehicle : world_.vehicles()) {
    if (vehicle->name == request.model_name)
      return fmt::format("model '{}' is there already", request.model_name);
  }
  try {
    ModelState pose = modelState(request.initial_pose, geometry_msgs::Twist());
    if (frame) pose = fromFrame(modelState(frame->simulator.state()), pose);
    if (world_.ground() && pose.position.z() < 0) {
      return fmt::format("initial_pose is at z = {} m; must be >= 0, above the ground",
                         quad_support::shortest(pose.position.z()));
    }
    VehicleSpec spec{request.model_name,
                     parseVehicle(request.model_xml, "model_xml"),
                     world_.first().simulator.options(),
                     {}};
    spec.start.rotor_speed.assign(spec.model.rotors.size(), 0.0);
    spec.start = moved(spec.start, pose);
    world_.add(spec);
  } catch (const std::exception& e) {  // whatever is wrong with a model, the world goes on
    return e.what();
  }
  return "";
}

bool SpawnServices::onSpawn(Spawn::Request& request, Spawn::Response& response) {
  const std::string problem = spawn(request);
  response.success = problem.empty();
  response.status_message =
      "SpawnModel: " + (problem.empty() ? "Successfully spawned entity" : problem);
  return true;
}

bool SpawnServices::onSpawnSdf(Spawn::Request&, Spawn::Response& response) {
  response.status_message =
      "SpawnModel: SDF is not read; give the model as URDF to /gazebo/spawn_urdf_model";
  return true;
}

std::string SpawnServices::remove(const std::string& name) {
  Vehicle* const vehicle = world_.find(name);  // no visit: vehicles come and go on this thread only
  if (!vehicle || vehicle->name != name) return world_.nobody(name);  // not by the robot's name
  if (world_.vehicles().size() == 1) {
    return fmt::format("'{}' is the last vehicle, and the clock is its; spawn another one first",
                       name);
  }
  world_.remove(*vehicle);
  return "";
}

bool SpawnServices::onDelete(gazebo_msgs::DeleteModel::Request& request,
                             gazebo_msgs::DeleteModel::Response& response) {
  const std::string problem = remove(request.model_name);
  response.success = problem.empty();
  response.status_message =
      "DeleteModel: " + (problem.empty() ? "successfully deleted model" : problem);
  return true;
}

}  // namespace quad_sim
