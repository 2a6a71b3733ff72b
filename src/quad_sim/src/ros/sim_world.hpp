/// The simulated world behind the ROS node: its vehicles and its clock, shared by services and pacing.
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/ros.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pacer.hpp"
#include "vehicle.hpp"
#include "world_gate.hpp"

namespace quad_sim {

/// Runs a callback where it arrives, in roscpp's network thread, instead of waking another thread for it. Only for
/// callbacks that are short and wait for nothing.
class ImmediateQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override { callback->call(); }
  void removeByID(std::uint64_t) override {}
};

struct SimNodeOptions {
  int publish_every = 0;        ///< physics steps between publications while unpaused; 0: only when stopped
  double real_time_factor = 1;  ///< simulated over wall time while unpaused; 0: as fast as it goes
  bool paused = true;           ///< at the start
};

/// Vehicles by name on one clock. All of them move by the same steps, in the order of their names.
class SimWorld {
 public:
  SimWorld(const std::vector<VehicleSpec>& fleet, const SimNodeOptions& options);
  ~SimWorld();

  WorldGate& gate() { return gate_; }
  const std::vector<std::unique_ptr<Vehicle>>& vehicles() { return vehicles_; }
  Vehicle& first() { return *vehicles_.front(); }
  Vehicle* find(const std::string& name);  ///< by namespace, or by the robot's name if one has it alone; nullptr: nobody
  bool running() const { return pacer_.running(); }
  void stopWaiting();  ///< who waits for a command is told that none will come

  // What follows is for within a visit to the gate.
  std::int64_t timeNanoseconds() { return first().simulator.timeNanoseconds(); }
  double step() { return first().simulator.options().step; }
  double gravity() { return first().simulator.options().gravity; }
  bool ground() { return first().simulator.options().ground; }
  double realTimeFactor() const { return pacer_.realTimeFactor(); }

  void advance(std::int64_t steps);  ///< stops where sensors have instants of their own
  void publish();                    ///< the present state on every topic
  void setRunning(bool running);
  void reset(bool time_too);
  /// Step [s], gravity [m/s²] and real-time factor, from now on. @throws std::invalid_argument; nothing has changed then
  void setPhysics(double step, double gravity, double real_time_factor);
  std::string save();
  /// @throws quad_support::DataError; nothing has changed then
  void restore(const std::string& state);

 private:
  void run(std::int64_t steps);
  void publishModelStates();

  SimNodeOptions options_;
  WorldGate gate_;
  ImmediateQueue topic_queue_;
  ros::NodeHandle handle_;
  std::vector<std::unique_ptr<Vehicle>> vehicles_;
  ros::Publisher clock_pub_, models_pub_;
  Pacer pacer_;
};

}  // namespace quad_sim
