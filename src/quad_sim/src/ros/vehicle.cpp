#include "vehicle.hpp"

#include <utility>

#include "quad_sim/plugin.hpp"
#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {
namespace {

Simulator simulatorOf(const VehicleSpec& spec) {
  Simulator simulator(spec.config.model, spec.config.options);
  simulator.setStartState(spec.start);
  return simulator;
}

}  // namespace

Vehicle::Vehicle(const VehicleSpec& spec, WorldGate& gate, std::function<bool()> running, ros::NodeHandle& handle)
    : name(spec.config.vehicle_namespace),
      simulator(simulatorOf(spec)),
      topics(simulator, name, handle),
      commands(simulator, name, gate, std::move(running), handle) {
  for (const std::string& note : simulator.model().notes) ROS_WARN("%s: %s", name.c_str(), note.c_str());
  for (const std::string& plugin : ignoredPlugins(simulator.model())) {
    ROS_INFO("%s: without effect in this version: %s", name.c_str(), plugin.c_str());
  }
}

void Vehicle::publish() {
  commands.published(toNanoseconds(toStamp(simulator.timeNanoseconds())));  // first: the answer may come at once
  topics.publish();
}

void Vehicle::reset(bool time_too) {
  commands.clear();
  time_too ? simulator.reset() : simulator.resetWorld();
  topics.start();
}

}  // namespace quad_sim
