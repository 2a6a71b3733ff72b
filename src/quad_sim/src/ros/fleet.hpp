/// Which vehicles the world holds, by the node's parameters.
#pragma once

#include <ros/ros.h>

#include <string>
#include <vector>

#include "vehicle.hpp"

namespace quad_sim {

/// Without the parameter ~vehicles: the configuration's one vehicle, where the configuration puts
/// it. With it, a map from namespace to {urdf, mass, x, y, z [m], yaw [rad], hover}, all optional:
/// these vehicles instead, with the configuration's urdf, mass and altitude where nothing else is
/// said. `hover: false` starts with rotors at rest. The parameter ~seed takes precedence over the
/// configuration's simulation.seed.
/// @throws quad_support::ConfigError naming parameter, value and what is allowed
std::vector<VehicleSpec> readFleet(const ros::NodeHandle& own, const std::string& config_path);

}  // namespace quad_sim
