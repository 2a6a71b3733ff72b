/// Open-loop replay of rotor-speed commands, from table to table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quad_sim/simulator.hpp"
#include "quad_support/csv_table.hpp"

namespace quad_sim {

/// A command [rad/s] that acts from the first physics step that starts at or after `time_ns`.
struct TimedCommand {
  std::int64_t time_ns = 0;
  std::vector<double> rotor_speed;
};

/// Columns t,w0,w1,… with one w for each rotor, t [s] rising. @throws quad_support::DataError
/// naming line and column
std::vector<TimedCommand> readCommands(const quad_support::CsvTable& table, std::size_t rotors);

/// One row with columns x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,w0,w1,…: position [m] of base_link's
/// origin and its velocity [m/s] in world axes, body rates [rad/s], rotor speeds [rad/s]. @throws
/// quad_support::DataError
VehicleState readState(const quad_support::CsvTable& table, std::size_t rotors);

/// Flies the commands from the simulator's present state and returns the states as CSV: t, then
/// readState()'s columns; a row every `every` physics steps from now on, and one at the end. Rotors
/// stand still before the first command.
/// @param steps  physics steps, >= 0
/// @param every  >= 1
std::string replay(Simulator& simulator, const std::vector<TimedCommand>& commands,
                   std::int64_t steps, std::int64_t every);

}  // namespace quad_sim
