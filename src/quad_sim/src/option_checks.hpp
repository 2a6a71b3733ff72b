/// What a simulator takes, and where a vehicle rests. Not installed.
#pragma once

#include <cstdint>

#include "quad_sim/simulator.hpp"

namespace quad_sim {

/// @throws std::invalid_argument naming the option, value and limit
std::int64_t wholeNanoseconds(double seconds);
void check(const SimulatorOptions& options);
void check(const VehicleState& state, const VehicleModel& model);

/// Level, on the ground, rotors still.
VehicleState restState(const VehicleModel& model);

}  // namespace quad_sim
