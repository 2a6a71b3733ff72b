/// One vehicle of the world, with everything of it that is on ROS.
#pragma once

#include <ros/ros.h>

#include <functional>
#include <string>

#include "command_input.hpp"
#include "quad_sim/simulation_config.hpp"
#include "quad_sim/simulator.hpp"
#include "vehicle_topics.hpp"
#include "world_gate.hpp"

namespace quad_sim {

/// A vehicle that the world shall hold.
struct VehicleSpec {
  SimulationConfig config;   ///< vehicle_namespace is its name
  VehicleState start;        ///< where reset puts it
};

/// Simulator, commands and topics of one vehicle. Vehicles of one world share clock and ground and do not touch one another.
struct Vehicle {
  Vehicle(const VehicleSpec& spec, WorldGate& gate, std::function<bool()> running, ros::NodeHandle& handle);

  void publish();             ///< the present state on every topic
  void reset(bool time_too);  ///< vehicle, sensors and what arrived

  std::string name;
  Simulator simulator;
  VehicleTopics topics;
  CommandInput commands;
};

}  // namespace quad_sim
