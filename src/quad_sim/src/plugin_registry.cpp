#include <dlfcn.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"
#include "rotor_plugin.hpp"

namespace quad_sim {
namespace {

struct Entry {
  PluginRole role;
  MakePlugin make;  ///< force plugins only
};

Plugin* makeRotors(const VehicleModel& model, double step) { return new RotorPlugin(model, step); }

/// The one place where a filename gets its meaning. An ordered map: messages list the names in the same order always.
const std::map<std::string, Entry>& registry() {
  static const std::map<std::string, Entry> entries = {
      {"librotors_gazebo_motor_model.so", {PluginRole::kForce, makeRotors}},
      {"librotors_gazebo_odometry_plugin.so", {PluginRole::kSensor, nullptr}},
      {"librotors_gazebo_imu_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_multirotor_base_plugin.so", {PluginRole::kOutside, nullptr}},
      {"librotors_gazebo_controller_interface.so", {PluginRole::kOutside, nullptr}},
      {"librotors_gazebo_bag_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_gps_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_magnetometer_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_pressure_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_mavlink_interface.so", {PluginRole::kIgnored, nullptr}},
  };
  return entries;
}

}  // namespace

std::vector<std::string> knownPlugins() {
  std::vector<std::string> names;
  for (const auto& entry : registry()) names.push_back(entry.first);
  return names;
}

namespace {

/// The entry of a built-in plugin or of a library. @throws as pluginRole()
Entry find(const PluginDeclaration& declaration) {
  const auto it = registry().find(declaration.filename);
  if (it != registry().end()) return it->second;
  void* library = dlopen(declaration.filename.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library) {
    if (void* make = dlsym(library, "quad_sim_make_plugin")) {
      return {PluginRole::kForce, reinterpret_cast<MakePlugin>(make)};
    }
  }
  throw quad_support::ConfigError(
      fmt::format("{}: plugin '{}': no plugin is called {}; built in are {}; as a library: {}", declaration.where,
                  declaration.name, declaration.filename, fmt::join(knownPlugins(), ", "),
                  library ? "it exports no quad_sim_make_plugin" : dlerror()));
}

}  // namespace

PluginRole pluginRole(const PluginDeclaration& declaration) { return find(declaration).role; }

std::vector<std::string> ignoredPlugins(const VehicleModel& model) {
  std::map<std::string, std::vector<std::string>> names;
  for (const PluginDeclaration& declaration : model.plugins) {
    if (pluginRole(declaration) == PluginRole::kIgnored) names[declaration.filename].push_back(declaration.name);
  }
  std::vector<std::string> out;
  for (const auto& [filename, elements] : names) out.push_back(fmt::format("{} ({})", filename, fmt::join(elements, ", ")));
  return out;
}

std::vector<std::unique_ptr<Plugin>> makePlugins(const VehicleModel& model, double step) {
  std::vector<std::unique_ptr<Plugin>> plugins;
  std::vector<std::string> made;
  for (const PluginDeclaration& declaration : model.plugins) {
    const Entry entry = find(declaration);
    if (entry.role != PluginRole::kForce) continue;
    if (std::find(made.begin(), made.end(), declaration.filename) != made.end()) continue;
    made.push_back(declaration.filename);
    plugins.emplace_back(entry.make(model, step));
  }
  return plugins;
}

}  // namespace quad_sim
