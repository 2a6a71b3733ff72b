/// What a simulator consists of. Not installed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "body.hpp"
#include "quad_sim/plugin.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {

struct Simulator::World {
  World(const VehicleModel& m, const SimulatorOptions& o);
  std::unique_ptr<Body> makeBody() const;
  void restore(const VehicleState& state);
  void reset(const VehicleState& state);

  /// The body into that state, the rotors turning as they do.
  void placeBody(VehicleState state);

  /// Everything but the plant's state as at the start.
  void forget();

  void archive(StateArchive& a);

  std::vector<double> numbers();  ///< of the archive

  /// What a saved state must come from to fit.
  std::string description() const;

  void step() {
    StepInput input;
    body->motion(input);
    input.command = command.data();
    input.step = step_count;
    input.time = static_cast<double>(step_count * step_ns) * 1e-9;
    if (windy) blow(input);
    StepLoad load{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                  Eigen::Vector3d::Zero()};
    for (const auto& plugin : plugins) plugin->step(input, load);
    if (options.multibody == Multibody::kHinged) {
      for (const auto& plugin : plugins) plugin->save(rotors_after);
    }
    if (pushed) addPush(input.R_WB, load);
    on_ground = body->step(load, rotors_after.rotor_speed);
    if (on_ground && contact_step < 0) contact_step = step_count + 1;
    ++step_count;
  }

  /// From here on the plugins see the motion through the air.
  void blow(StepInput& input) {
    wind = outside_wind;
    for (Plugin* plugin : air) plugin->addWind(input, wind);
    input.v_WC_B -= input.R_WB.transpose() * wind;
  }

  void setWind(const Eigen::Vector3d& wind_W) {
    outside_wind = wind = wind_W;
    windy = !air.empty() || wind_W != Eigen::Vector3d::Zero();
  }

  void setPush(const Wrench& on_body) {
    push = on_body;
    pushed = push.force != Eigen::Vector3d::Zero() || push.torque != Eigen::Vector3d::Zero();
  }

  void addPush(const Eigen::Matrix3d& R_WB, StepLoad& load) const {
    load.force_B += R_WB.transpose() * push.force;
    load.torque_B += R_WB.transpose() * push.torque;
  }

  VehicleModel model;
  SimulatorOptions options;
  std::int64_t step_ns;
  WorldSettings settings;
  std::vector<std::unique_ptr<Plugin>> plugins;
  std::vector<Plugin*> air;  ///< those that move it
  Eigen::Vector3d outside_wind = Eigen::Vector3d::Zero(), wind = Eigen::Vector3d::Zero();
  bool windy = false;
  Wrench push;
  bool pushed = false;
  bool on_ground = false;  ///< in the last step
  std::unique_ptr<Body> body;
  VehicleState
      rotors_after;  ///< only the rotors' part of it: at the end of the step, for the hinges
  VehicleState start;
  std::vector<double> command;
  CommandCounts counts;
  std::int64_t step_count = 0;
  std::int64_t contact_step = -1;
};

}  // namespace quad_sim
