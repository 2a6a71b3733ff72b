/// The one interface behind which rotors, wind and the like act on the vehicle.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "quad_sim/state_archive.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

/// The world a plugin is made for.
struct WorldSettings {
  double step = 0.001;     ///< physics step [s]
  double gravity = 9.8;    ///< along -z [m/s²]
  std::uint64_t seed = 0;  ///< of every random number; draw by (seed, purpose, step), see
                           ///< quad_support/random_stream.hpp
  RotorsQuirks quirks;     ///< what of RotorS is to be reproduced
};

/// What a plugin sees at the start of a physics step.
struct StepInput {
  Eigen::Vector3d v_WC_B;  ///< velocity of the centre of mass through the air, body axes [m/s]
  Eigen::Vector3d w_WB_B;  ///< [rad/s]
  const double*
      command;  ///< commanded rotor speeds [rad/s], within [0, max_speed], by motor number
  std::int64_t step = 0;  ///< physics steps since reset
  double time = 0;        ///< simulated time [s], step times the step's length
  Eigen::Vector3d p_WC = Eigen::Vector3d::Zero();      ///< centre of mass [m]
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();  ///< B to W
};

/// What the plugins put on the body during the step, means over the step; each adds its share.
struct StepLoad {
  Eigen::Vector3d force_B;   ///< [N], body axes
  Eigen::Vector3d torque_B;  ///< about the centre of mass [N m], body axes
  /// Angular momentum of turning parts relative to the body [N m s], body axes: mean over the step,
  /// and at its end.
  Eigen::Vector3d momentum_mean_B, momentum_end_B;
};

/// A part of the vehicle, or of the air around it, that acts on the vehicle. One object serves all
/// declarations of one filename.
class Plugin {
 public:
  virtual ~Plugin() = default;

  /// Whether addWind() is to be called.
  virtual bool movesAir() const { return false; }
  /// Adds its share to the velocity of the air at the vehicle [m/s], world axes. Called for all
  /// such plugins before any step(); `input.v_WC_B` is then still the velocity over ground. Must
  /// not allocate.
  virtual void addWind(const StepInput& input, Eigen::Vector3d& wind_W) {
    static_cast<void>(input);
    static_cast<void>(wind_W);
  }

  /// Moves the plugin's own state by one physics step and adds its load. Must not allocate.
  virtual void step(const StepInput& input, StepLoad& load) = 0;

  /// Takes over the part of a state that is the plugin's. Everything else it remembers starts
  /// afresh.
  virtual void restore(const VehicleState& state) = 0;
  /// As restore(), at the start of a flight or of its repetition.
  virtual void reset(const VehicleState& state) { restore(state); }
  /// Writes its part of the state.
  virtual void save(VehicleState& state) const = 0;

  /// Passes everything the plugin carries from one step to the next through the archive, in a fixed
  /// order, whichever way it goes: after loading, the plugin continues bit for bit where it was
  /// saved. Nothing to do without a memory.
  virtual void archive(StateArchive& /*archive*/) {}

  /// Force from outside the vehicle during the last step [N], world axes, to be told to users; a
  /// part of what step() added.
  virtual Eigen::Vector3d outsideForce() const { return Eigen::Vector3d::Zero(); }

  /// Angular momentum now of turning parts relative to the body [N m s], body axes.
  virtual Eigen::Vector3d momentum() const { return Eigen::Vector3d::Zero(); }
};

/// Makes a plugin for a vehicle; its declarations are those among `model.plugins` that name its
/// filename.
/// @throws quad_support::ConfigError, best by PluginDeclaration::fail()
using MakePlugin = Plugin* (*)(const VehicleModel& model, const WorldSettings& world);

/// Changes whenever a library must be compiled anew.
constexpr int kPluginInterface = 3;

/// A library outside this package becomes a force plugin by this line, outside any namespace;
/// `Class` has a constructor (const VehicleModel&, const WorldSettings&). A vehicle asks for it by
/// the library's name or path in <plugin filename="…">; a name is looked for where the dynamic
/// linker looks, LD_LIBRARY_PATH first. The simulator deletes the object; the library stays loaded.
#define QUAD_SIM_REGISTER_PLUGIN(Class)                                                     \
  extern "C" int quad_sim_plugin_interface() { return quad_sim::kPluginInterface; }         \
  extern "C" quad_sim::Plugin* quad_sim_make_plugin(const quad_sim::VehicleModel& model,    \
                                                    const quad_sim::WorldSettings& world) { \
    return new Class(model, world);                                                         \
  }

/// What a plugin library is to the simulator.
enum class PluginRole {
  kForce,    ///< made by makePlugins()
  kSensor,   ///< read into VehicleModel::sensors
  kOutside,  ///< part of the simulator itself or of its ROS node (controller interface, multirotor
             ///< base, bag)
  kIgnored,  ///< known and without effect in this version; VehicleModel users may tell
};

/// Filenames of the plugins built in, sorted.
std::vector<std::string> knownPlugins();

/// Looks among the plugins built in, then for a library of that name (see
/// QUAD_SIM_REGISTER_PLUGIN).
/// @throws quad_support::ConfigError naming the element, the filenames built in, and why no library
/// was found
PluginRole pluginRole(const PluginDeclaration& declaration);

/// What a vehicle declares and this version leaves out: "librotors_gazebo_gps_plugin.so (gps)".
/// Tell the user, once.
std::vector<std::string> ignoredPlugins(const VehicleModel& model);

/// Makes the force plugins a vehicle declares, one per filename, in the order they first appear.
std::vector<std::unique_ptr<Plugin>> makePlugins(const VehicleModel& model,
                                                 const WorldSettings& world);

}  // namespace quad_sim
