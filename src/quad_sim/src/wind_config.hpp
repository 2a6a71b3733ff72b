/// The section simulation.wind: a wind for whatever vehicle, in the place of the URDF's. Not
/// installed.
#pragma once

#include "quad_sim/simulation_config.hpp"

namespace quad_sim {

/// Reads and checks simulation.wind; nullopt if there is none.
/// @throws quad_support::ConfigError with file, line, key, value and what is allowed
std::optional<WindConfig> readWind(const quad_support::ConfigReader& simulation);

/// Puts the wind into the model: what the URDF declares of wind goes, and the plugin is declared
/// with these numbers. No numbers: calm.
void putWind(const WindConfig& wind, VehicleModel& model);

}  // namespace quad_sim
