#include <dlfcn.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"
#include "quirky_rotor_plugin.hpp"
#include "rotor_plugin.hpp"
#include "wind_plugin.hpp"

namespace quad_sim {
namespace {

struct Entry {
  PluginRole role;
  MakePlugin make;  ///< force plugins only
};

Plugin* makeRotors(const VehicleModel& model, const WorldSettings& world) {
  const RotorsQuirks& q = world.quirks;
  const bool quirky =
      q.thrust_lag || q.unchecked_commands || q.rolling_moment_sign || q.filter_survives_reset;
  if (quirky) return new QuirkyRotorPlugin(model, world);
  return new RotorPlugin(model, world.step);
}

Plugin* makeWind(const VehicleModel& model, const WorldSettings& world) {
  return new WindPlugin(model, world);
}

/// The one place where a filename gets its meaning. An ordered map: messages list the names in the
/// same order always.
const std::map<std::string, Entry>& registry() {
  static const std::map<std::string, Entry> entries = {
      {"librotors_gazebo_motor_model.so", {PluginRole::kForce, makeRotors}},
      {"librotors_gazebo_odometry_plugin.so", {PluginRole::kSensor, nullptr}},
      {"librotors_gazebo_imu_plugin.so", {PluginRole::kSensor, nullptr}},
      {"librotors_gazebo_wind_plugin.so", {PluginRole::kForce, makeWind}},
      {"librotors_gazebo_bag_plugin.so", {PluginRole::kOutside, nullptr}},
      {"librotors_gazebo_multirotor_base_plugin.so", {PluginRole::kOutside, nullptr}},
      {"librotors_gazebo_controller_interface.so", {PluginRole::kOutside, nullptr}},
      {"librotors_gazebo_ros_interface_plugin.so", {PluginRole::kOutside, nullptr}},
      {"libLiftDragPlugin.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_geotagged_images_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_block_laser.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_camera.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_control.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_depth_camera.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_gpu_laser.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_imu.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_laser.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_multicamera.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_openni_kinect.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_p3d.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_range.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_aerodynamics_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_fw_dynamics_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_gimbal_controller_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_gps_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_gst_camera_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_lidar_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_magnetometer_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_mavlink_interface.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_noisydepth_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_octomap_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_optical_flow_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_pressure_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_propulsion_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_springdamper_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"librotors_gazebo_tracking_cam_plugin.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_velodyne_laser.so", {PluginRole::kIgnored, nullptr}},
      {"libgazebo_ros_joint_state_publisher.so", {PluginRole::kIgnored, nullptr}},
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
  std::string problem = library ? "" : dlerror();
  if (library) {
    void* const make = dlsym(library, "quad_sim_make_plugin");
    const auto interface = reinterpret_cast<int (*)()>(dlsym(library, "quad_sim_plugin_interface"));
    if (make && interface && interface() == kPluginInterface)
      return {PluginRole::kForce, reinterpret_cast<MakePlugin>(make)};
    problem = make && interface ? fmt::format(
                                      "it was compiled for plugin interface {}, this is {}; "
                                      "compile it again",
                                      interface(), kPluginInterface)
                                : "it is no plugin: quad_sim/plugin.hpp's QUAD_SIM_REGISTER_PLUGIN "
                                  "makes one";
  }
  throw quad_support::ConfigError(
      fmt::format("{}: plugin '{}': no plugin is called {}; built in are {}; as a library: {}",
                  declaration.where, declaration.name, declaration.filename,
                  fmt::join(knownPlugins(), ", "), problem));
}

}  // namespace

PluginRole pluginRole(const PluginDeclaration& declaration) { return find(declaration).role; }

std::vector<std::string> ignoredPlugins(const VehicleModel& model) {
  std::map<std::string, std::vector<std::string>> names;
  for (const PluginDeclaration& declaration : model.plugins) {
    if (pluginRole(declaration) == PluginRole::kIgnored)
      names[declaration.filename].push_back(declaration.name);
  }
  std::vector<std::string> out;
  for (const auto& [filename, elements] : names)
    out.push_back(fmt::format("{} ({})", filename, fmt::join(elements, ", ")));
  return out;
}

std::vector<std::unique_ptr<Plugin>> makePlugins(const VehicleModel& model,
                                                 const WorldSettings& world) {
  std::vector<std::unique_ptr<Plugin>> plugins;
  std::vector<std::string> made;
  for (const PluginDeclaration& declaration : model.plugins) {
    const Entry entry = find(declaration);
    if (entry.role != PluginRole::kForce) continue;
    if (std::find(made.begin(), made.end(), declaration.filename) != made.end()) continue;
    made.push_back(declaration.filename);
    plugins.emplace_back(entry.make(model, world));
  }
  return plugins;
}

}  // namespace quad_sim
