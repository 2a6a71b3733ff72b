/// One vehicle of the world, with everything of it that is on ROS.
#pragma once

#include <ros/ros.h>

#include <functional>
#include <memory>
#include <string>

#include "bag_recorder.hpp"
#include "command_input.hpp"
#include "pushes.hpp"
#include "quad_sim/simulator.hpp"
#include "vehicle_topics.hpp"
#include "world_gate.hpp"

namespace quad_sim {

/// A vehicle that the world shall hold.
struct VehicleSpec {
  std::string name;  ///< and namespace, without slashes at its ends
  VehicleModel model;
  SimulatorOptions options;
  VehicleState start;  ///< where reset puts it
};

/// What a vehicle needs of the node it lives in.
struct Surroundings {
  WorldGate& gate;
  std::function<bool()> running;
  ros::NodeHandle& topics;    ///< callbacks where they arrive
  ros::NodeHandle& services;  ///< callbacks on the services' thread
};

/// Simulator, commands and topics of one vehicle. Vehicles of one world share clock and ground and
/// do not touch one another.
struct Vehicle {
  Vehicle(const VehicleSpec& spec, const Surroundings& around);

  void publish();                   ///< the present state on every topic
  void reset(bool time_too);        ///< vehicle, sensors and what arrived
  std::int64_t nextEvent() const;   ///< the next step at which atEvent() must be called
  void atEvent();                   ///< sensors, pushes and bag with instants of their own
  void archive(StateArchive& all);  ///< what is not in the simulator's saved state

  std::string name;
  Simulator simulator;
  VehicleTopics topics;
  Pushes pushes;
  std::unique_ptr<BagRecorder> bag;  ///< nullptr: the model declares none
  CommandInput commands;  ///< last: when a vehicle comes to nothing, none may wait for the world
};

/// The latest speeds and angles of the rotors' joints, by motor number, as joint_states tells them.
struct JointMotion {
  double angle;  ///< [rad]
  double speed;  ///< [rad/s], slowed down and signed
};
JointMotion jointMotion(const Vehicle& vehicle, const RotorModel& rotor);

}  // namespace quad_sim
