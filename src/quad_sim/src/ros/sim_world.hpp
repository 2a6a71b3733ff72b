/// The simulated world behind the ROS node: its vehicles and its clock, shared by services and
/// pacing.
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/ros.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model_state.hpp"
#include "pacer.hpp"
#include "speedometer.hpp"
#include "vehicle.hpp"
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
  int publish_every =
      0;  ///< physics steps between publications while unpaused; 0: only when stopped
  double real_time_factor = 1;  ///< simulated over wall time while unpaused; 0: as fast as it goes
  bool paused = true;           ///< at the start
};

/// A link in the world; nullptr: there is none of that name.
struct LinkOf {
  Vehicle* vehicle = nullptr;
  const LinkModel* link = nullptr;
};

/// What Gazebo knows of a vehicle's links: base_link, and those whose joint to it can move.
std::vector<const LinkModel*> bodies(const VehicleModel& model);
/// Its motion in the world; of a rotor's link with the angle of the latest publication.
ModelState linkState(const Vehicle& vehicle, const LinkModel& link);

/// Whether a service's reference frame means the inertial one.
bool isWorld(const std::string& frame);

/// Vehicles by name on one clock. All of them move by the same steps, in the order of their names,
/// those that came later last.
class SimWorld {
 public:
  /// @param services  handle for the vehicles' own services, which may wait for the gate
  SimWorld(const std::vector<VehicleSpec>& fleet, const SimNodeOptions& options,
           const ros::NodeHandle& services);
  ~SimWorld();

  WorldGate& gate() { return gate_; }
  const std::vector<std::unique_ptr<Vehicle>>& vehicles() { return vehicles_; }
  Vehicle& first() { return *vehicles_.front(); }
  Vehicle* find(const std::string& name);  ///< by namespace, or by the robot's name if one has it
                                           ///< alone; nullptr: nobody
  std::string nobody(
      const std::string& name) const;  ///< that find() finds nobody of that name, and who is there
  /// By "model::link", or "link" if one vehicle alone has it; `link` with or without the model's
  /// own prefix.
  LinkOf findLink(const std::string& name);
  bool running() const { return pacer_.running(); }
  /// Takes a vehicle that is not the last one out of the world. Not from within a visit.
  void remove(Vehicle& vehicle);
  void stopWaiting();  ///< who waits for a command is told that none will come

  // What follows is for within a visit to the gate.
  std::int64_t timeNanoseconds() { return first().simulator.timeNanoseconds(); }
  double step() { return first().simulator.options().step; }
  double gravity() { return first().simulator.options().gravity; }
  bool ground() { return first().simulator.options().ground; }
  double realTimeFactor() const { return pacer_.realTimeFactor(); }

  /// From now on in the world, at the present time. @throws what a vehicle may be wrong with;
  /// nothing has changed then
  void add(const VehicleSpec& spec);
  void advance(std::int64_t steps);  ///< stops where sensors have instants of their own
  void publish();                    ///< the present state on every topic
  void setRunning(bool running);
  void reset(bool time_too);
  /// Step [s], gravity [m/s²] and real-time factor, from now on. @throws std::invalid_argument;
  /// nothing has changed then
  void setPhysics(double step, double gravity, double real_time_factor);
  std::string save();
  /// @throws quad_support::DataError; nothing has changed then
  void restore(const std::string& state);

 private:
  void run(std::int64_t steps);
  void publishModelStates();
  void publishLinkStates();
  Surroundings surroundings() {
    return {gate_, [this] { return running(); }, handle_, services_};
  }

  SimNodeOptions options_;
  WorldGate gate_;
  ImmediateQueue topic_queue_;
  ros::NodeHandle handle_, services_;
  std::vector<std::unique_ptr<Vehicle>> vehicles_;
  ros::Publisher clock_pub_, models_pub_, links_pub_;
  Speedometer speedometer_{handle_};
  Pacer pacer_;
};

}  // namespace quad_sim
