#include "vehicle.hpp"

#include <algorithm>

#include "quad_sim/plugin.hpp"
#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {
namespace {

Simulator simulatorOf(const VehicleSpec& spec) {
  Simulator simulator(spec.model, spec.options);
  simulator.setStartState(spec.start);
  return simulator;
}

}  // namespace

Vehicle::Vehicle(const VehicleSpec& spec, const Surroundings& around)
    : name(spec.name),
      simulator(simulatorOf(spec)),
      topics(simulator, name, around.topics),
      pushes(simulator),
      bag(makeBagRecorder(simulator, name, around.topics, around.services)),
      commands(simulator, name, around.gate, around.running, around.topics) {
  for (const std::string& note : simulator.model().notes) {
    ROS_WARN("%s: %s", name.c_str(), note.c_str());
  }
  for (const std::string& plugin : ignoredPlugins(simulator.model())) {
    ROS_INFO("%s: without effect in this version: %s", name.c_str(), plugin.c_str());
  }
}

void Vehicle::publish() {
  // first: the answer may come at once
  commands.published(toNanoseconds(toStamp(simulator.timeNanoseconds())));
  topics.publish();
  if (bag) bag->setTime();
}

void Vehicle::reset(bool time_too) {
  commands.clear();
  pushes.clear();
  time_too ? simulator.reset() : simulator.resetWorld();
  topics.start();
}

std::int64_t Vehicle::nextEvent() const {
  const std::int64_t next = std::min(topics.nextEvent(), pushes.nextEvent());
  return bag ? std::min(next, bag->nextEvent()) : next;
}

void Vehicle::atEvent() {
  topics.atEvent();
  pushes.apply();
  if (bag) bag->atEvent();
}

void Vehicle::archive(StateArchive& all) {
  topics.archive(all);
  pushes.archive(all);
}

JointMotion jointMotion(const Vehicle& vehicle, const RotorModel& rotor) {
  const std::size_t i = static_cast<std::size_t>(rotor.motor_number);
  const double speed = vehicle.simulator.measure().rotor_speed.at(i);
  return {vehicle.topics.jointAngles().at(i), rotor.spin * speed / rotor.slowdown};
}

}  // namespace quad_sim
