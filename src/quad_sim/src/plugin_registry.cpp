#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"
#include "rotor_plugin.hpp"

namespace quad_sim {
namespace {

using Factory = std::unique_ptr<Plugin> (*)(const VehicleModel&, double step);

struct Entry {
  PluginRole role;
  Factory make;  ///< force plugins only
};

std::unique_ptr<Plugin> makeRotors(const VehicleModel& model, double step) {
  return std::make_unique<RotorPlugin>(model, step);
}

/// The one place where a filename gets its meaning. An ordered map: messages list the names in the same order always.
const std::map<std::string, Entry>& registry() {
  static const std::map<std::string, Entry> entries = {
      {"librotors_gazebo_motor_model.so", {PluginRole::kForce, makeRotors}},
      {"librotors_gazebo_odometry_plugin.so", {PluginRole::kSensor, nullptr}},
      {"librotors_gazebo_imu_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_multirotor_base_plugin.so", {PluginRole::kOutside, nullptr}},
      {"librotors_gazebo_controller_interface.so", {PluginRole::kOutside, nullptr}},
  };
  return entries;
}

}  // namespace

std::vector<std::string> knownPlugins() {
  std::vector<std::string> names;
  for (const auto& entry : registry()) names.push_back(entry.first);
  return names;
}

PluginRole pluginRole(const PluginDeclaration& declaration) {
  const auto it = registry().find(declaration.filename);
  if (it == registry().end()) {
    throw quad_support::ConfigError(fmt::format("{}: plugin '{}': no plugin is called {}; known are {}", declaration.where,
                                                declaration.name, declaration.filename,
                                                fmt::join(knownPlugins(), ", ")));
  }
  return it->second.role;
}

std::vector<std::unique_ptr<Plugin>> makePlugins(const VehicleModel& model, double step) {
  std::vector<std::unique_ptr<Plugin>> plugins;
  std::vector<std::string> made;
  for (const PluginDeclaration& declaration : model.plugins) {
    if (pluginRole(declaration) != PluginRole::kForce) continue;
    if (std::find(made.begin(), made.end(), declaration.filename) != made.end()) continue;
    made.push_back(declaration.filename);
    plugins.push_back(registry().at(declaration.filename).make(model, step));
  }
  return plugins;
}

}  // namespace quad_sim
