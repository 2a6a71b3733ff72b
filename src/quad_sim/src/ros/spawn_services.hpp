/// Vehicles that come and go while the world exists.
#pragma once

#include <gazebo_msgs/DeleteModel.h>
#include <gazebo_msgs/SpawnModel.h>
#include <ros/ros.h>

#include <string>
#include <vector>

#include "sim_world.hpp"

namespace quad_sim {

/// spawn_urdf_model, delete_model, and spawn_sdf_model, which says that it cannot.
///
/// A vehicle joins between two steps at the present time, rotors at rest, with the physics of the
/// world. Clock and other vehicles do not notice.
class SpawnServices {
 public:
  SpawnServices(SimWorld& world, ros::NodeHandle& handle);

 private:
  using Spawn = gazebo_msgs::SpawnModel;
  bool onSpawn(Spawn::Request&, Spawn::Response&);
  bool onSpawnSdf(Spawn::Request&, Spawn::Response&);
  bool onDelete(gazebo_msgs::DeleteModel::Request&, gazebo_msgs::DeleteModel::Response&);

  /// What went wrong; empty if nothing did.
  std::string spawn(const Spawn::Request& request);
  std::string remove(const std::string& name);

  SimWorld& world_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace quad_sim
