/// The one interface behind which rotors, wind and the like act on the vehicle.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "quad_sim/state_archive.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

/// What a plugin sees at the start of a physics step.
struct StepInput {
  Eigen::Vector3d v_WC_B;  ///< velocity of the centre of mass through the air, body axes [m/s]
  Eigen::Vector3d w_WB_B;  ///< [rad/s]
  const double* command;   ///< commanded rotor speeds [rad/s], within [0, max_speed], by motor number
};

/// What the plugins put on the body during the step, means over the step; each adds its share.
struct StepLoad {
  Eigen::Vector3d force_B;   ///< [N], body axes
  Eigen::Vector3d torque_B;  ///< about the centre of mass [N m], body axes
  /// Angular momentum of turning parts relative to the body [N m s], body axes: mean over the step, and at its end.
  Eigen::Vector3d momentum_mean_B, momentum_end_B;
};

/// A part of the vehicle with forces of its own. One object serves all declarations of one filename.
class Plugin {
 public:
  virtual ~Plugin() = default;
  /// Moves the plugin's own state by one physics step and adds its load. Must not allocate.
  virtual void step(const StepInput& input, StepLoad& load) = 0;
  /// Takes over the part of a state that is the plugin's. Everything else it remembers starts afresh.
  virtual void restore(const VehicleState& state) = 0;
  /// Writes its part of the state.
  virtual void save(VehicleState& state) const = 0;
  /// Passes everything the plugin carries from one step to the next through the archive, in a fixed order, whichever
  /// way it goes: after loading, the plugin continues bit for bit where it was saved. Nothing to do without a memory.
  virtual void archive(StateArchive& /*archive*/) {}
  /// Angular momentum now of turning parts relative to the body [N m s], body axes.
  virtual Eigen::Vector3d momentum() const { return Eigen::Vector3d::Zero(); }
};

/// A library outside this package becomes a force plugin by exporting, under the name `quad_sim_make_plugin` and with
/// extern "C", a function of this type. A vehicle asks for it by the library's name or path in <plugin filename="…">.
/// The object is deleted by the simulator; the library stays loaded.
using MakePlugin = Plugin* (*)(const VehicleModel& model, double step);

/// What a plugin library is to the simulator.
enum class PluginRole {
  kForce,    ///< made by makePlugin()
  kSensor,   ///< read into VehicleModel::sensors
  kOutside,  ///< part of the simulator itself or of its ROS node (controller interface, multirotor base)
  kIgnored,  ///< known and without effect in this version; VehicleModel users may tell
};

/// Filenames of the plugins built in, sorted.
std::vector<std::string> knownPlugins();

/// Looks among the plugins built in, then for a library of that name (see MakePlugin).
/// @throws quad_support::ConfigError naming the element, the filenames built in, and why no library was found
PluginRole pluginRole(const PluginDeclaration& declaration);

/// What a vehicle declares and this version leaves out: "librotors_gazebo_imu_plugin.so (imu, imugt)". Tell the user.
std::vector<std::string> ignoredPlugins(const VehicleModel& model);

/// Makes the force plugins a vehicle declares, one per filename, in the order they first appear.
/// @param step  physics step [s]
std::vector<std::unique_ptr<Plugin>> makePlugins(const VehicleModel& model, double step);

}  // namespace quad_sim
