/// The sections `vehicle` and `simulation` of an experiment's YAML file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "quad_sim/simulator.hpp"
#include "quad_support/config_reader.hpp"

namespace quad_sim {

/// The keys of simulation.wind that are given, with their one or three numbers (docs/forces.md).
using WindConfig = std::map<std::string, std::vector<double>>;

struct SimulationConfig {
  std::string urdf;                ///< path found by findUrdf()
  std::string vehicle_namespace;   ///< ROS names start with it
  std::optional<double> mass;      ///< total [kg]; nullopt keeps the URDF's
  std::optional<WindConfig> wind;  ///< in place of the URDF's; nullopt keeps the URDF's
  SimulatorOptions options;
  double initial_altitude = 0;  ///< of base_link's origin [m]
  VehicleModel model;           ///< loadVehicle() of the above
};

/// Reads and checks both sections; unknown keys are errors.
/// @throws quad_support::ConfigError with file, line, key, value and what is allowed
SimulationConfig readSimulationConfig(const quad_support::ConfigReader& vehicle,
                                      const quad_support::ConfigReader& simulation);

/// Reads the two sections of a file that may hold others.
SimulationConfig readSimulationConfig(const std::string& yaml_path);

/// Reads the configured URDF, with the configured mass and wind.
VehicleModel loadVehicle(const SimulationConfig& config);

/// A simulator at the configured start: equilibrium() at initial_altitude.
Simulator makeSimulator(const SimulationConfig& config, const VehicleModel& model);

/// Where a URDF named in a configuration file is: an absolute path as it stands; else beside the
/// configuration file; else in a folder `urdf` or `share/quad_sim/urdf` beside or above this
/// library (that is build/urdf when it runs from the build, and the installed models when
/// installed). Empty if it is nowhere.
std::string findUrdf(const std::string& name, const std::string& config_folder);

}  // namespace quad_sim
