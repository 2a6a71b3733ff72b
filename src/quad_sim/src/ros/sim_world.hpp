/// The simulated world behind the ROS node: vehicle, clock, commands and topics, shared by services
/// and pacing.
#pragma once

#include <mav_msgs/Actuators.h>
#include <ros/callback_queue_interface.h>
#include <ros/ros.h>

#include <cstdint>
#include <string>

#include "command_inbox.hpp"
#include "pacer.hpp"
#include "quad_sim/simulation_config.hpp"
#include "quad_sim/simulator.hpp"
#include "vehicle_topics.hpp"
#include "world_gate.hpp"

namespace quad_sim {

/// Runs a callback where it arrives, in roscpp's network thread, instead of waking another thread
/// for it. Only for callbacks that are short and wait for nothing.
class ImmediateQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override {
    callback->call();
  }
  void removeByID(std::uint64_t) override {}
};

struct SimNodeOptions {
  int odometry_every =
      0;  ///< physics steps between publications while unpaused; 0: only when stopped
  double real_time_factor = 1;  ///< simulated over wall time while unpaused; 0: as fast as it goes
  bool paused = true;           ///< at the start
};

/// The vehicle, and what comes in and goes out for it over topics.
///
/// Commands come in on roscpp's network thread. While paused a command waits for the Step that asks
/// for it; while running it acts from the next physics step on.
class SimWorld {
 public:
  SimWorld(const SimulationConfig& config, const SimNodeOptions& options);
  ~SimWorld();

  WorldGate& gate() { return gate_; }
  CommandInbox& inbox() { return inbox_; }
  const SimulationConfig& config() const { return config_; }
  const std::string& vehicleName() const { return config_.vehicle_namespace; }
  bool running() const { return pacer_.running(); }
  double realTimeFactor() const { return pacer_.realTimeFactor(); }

  // What follows is for within a visit to the gate.
  Simulator& simulator() { return simulator_; }
  const VehicleTopics& topics() const { return topics_; }
  bool isModel(const std::string& name) const;  ///< whether the vehicle goes by it
  void publish();                               ///< the present state on every topic
  void setRunning(bool running);
  void reset(bool time_too);

 private:
  void onCommand(const mav_msgs::Actuators& message);
  void run(std::int64_t steps);

  SimulationConfig config_;
  SimNodeOptions options_;
  Simulator simulator_;
  WorldGate gate_;
  CommandInbox inbox_;
  ImmediateQueue topic_queue_;
  ros::NodeHandle handle_;
  VehicleTopics topics_;
  ros::Publisher clock_pub_;
  Pacer pacer_;
  ros::Subscriber command_sub_;
};

}  // namespace quad_sim
