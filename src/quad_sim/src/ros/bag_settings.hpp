/// What a <plugin filename="librotors_gazebo_bag_plugin.so"> asks for.
#pragma once

#include <cstdint>
#include <string>

#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

/// RotorS's tags with RotorS's defaults; topics relative to the vehicle's namespace.
struct BagSettings {
  /// @throws quad_support::ConfigError naming element and tag
  BagSettings(const PluginDeclaration& declaration, const VehicleModel& model);

  std::string file;       ///< as written: a folder that exists, and the start of the name
  LinkModel link;         ///< whose true motion is recorded
  std::string frame;      ///< of its pose and twist
  std::string service;    ///< starts and stops
  bool wait;              ///< for the service; else recording starts with the simulator
  std::int64_t cycle_us;  ///< between instants of the true motion: 10 ms, or 1 / updateRate (ours)
  std::string force_frame = "world";  ///< of external_force
  std::string pose, twist, motor_speed, wrench, imu, external_force, wind_speed;
  std::string trajectory, command_pose, attitude_thrust, command_motor_speed, rate_thrust;
};

/// "logs/bee.bag" at that wall-clock second: "logs/bee_2026-11-22-08-30-00.bag", as RotorS names
/// it; with a number behind it where a file of that name is already.
std::string bagName(const std::string& file, std::int64_t unix_seconds);

}  // namespace quad_sim
