/// The simulator as a ROS node that speaks like Gazebo with RotorS's plugins, plus /gazebo/step.
#pragma once

#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/SetModelState.h>
#include <mav_msgs/Actuators.h>
#include <quad_sim/Step.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "command_inbox.hpp"
#include "quad_sim/simulation_config.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {

/// Runs a callback where it arrives, in roscpp's network thread, instead of waking another thread for it. Only for
/// callbacks that are short and wait for nothing.
class ImmediateQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override { callback->call(); }
  void removeByID(std::uint64_t) override {}
};

struct SimNodeOptions {
  int odometry_every = 0;       ///< physics steps between publications while unpaused; 0: only when stopped
  double real_time_factor = 1;  ///< simulated over wall time while unpaused; 0: as fast as it goes
  bool paused = true;           ///< at the start
};

/// Topics, services and the thread that runs the physics while unpaused.
///
/// Commands come in on roscpp's network thread, so that a Step may wait for one on the services' thread. While paused a command waits for the
/// Step that asks for it; while running it acts from the next physics step on.
class SimNode {
 public:
  SimNode(const SimulationConfig& config, const SimNodeOptions& options);
  ~SimNode();

 private:
  using Empty = std_srvs::Empty;
  void onCommand(const mav_msgs::Actuators& message);
  bool onStep(Step::Request& request, Step::Response& response);
  bool onPause(Empty::Request&, Empty::Response&);
  bool onUnpause(Empty::Request&, Empty::Response&);
  bool onResetWorld(Empty::Request&, Empty::Response&);
  bool onResetSimulation(Empty::Request&, Empty::Response&);
  bool onGetModelState(gazebo_msgs::GetModelState::Request&, gazebo_msgs::GetModelState::Response&);
  bool onSetModelState(gazebo_msgs::SetModelState::Request&, gazebo_msgs::SetModelState::Response&);
  bool onGetWorldProperties(gazebo_msgs::GetWorldProperties::Request&, gazebo_msgs::GetWorldProperties::Response&);
  bool onGetPhysicsProperties(gazebo_msgs::GetPhysicsProperties::Request&,
                              gazebo_msgs::GetPhysicsProperties::Response&);

  void advertise();
  std::string runStep(const Step::Request& request);  ///< what went wrong; empty if nothing did
  std::string groundMessage() const;
  bool isModel(const std::string& name) const;
  void publishOthers(const Measurement& measured);
  void publish();  ///< the present state on every topic; fills last_odometry_, last_motor_speed_
  void reset(bool time_too);
  void runLoop();
  std::int64_t runDue(std::chrono::steady_clock::time_point since, std::int64_t done);
  void runSteps(std::int64_t steps);

  SimulationConfig config_;
  SimNodeOptions options_;
  VehicleModel model_;
  Simulator simulator_;
  const SensorModel* primary_ = nullptr;  ///< the odometry sensor controllers listen to: the URDF's first
  std::string ns_;                        ///< "/hummingbird/"

  std::mutex mutex_;               ///< guards the simulator and what is published
  std::atomic<int> waiting_{0};    ///< callers that want the mutex: the running loop lets them in
  std::condition_variable state_changed_;
  std::atomic<bool> running_{false};  ///< changed under the mutex only
  bool stop_ = false;
  CommandInbox inbox_;
  nav_msgs::Odometry last_odometry_;
  mav_msgs::Actuators last_motor_speed_;
  unsigned sequence_ = 0;  ///< of get_model_state's answers

  ImmediateQueue command_queue_;
  ros::CallbackQueue service_queue_;
  ros::NodeHandle topic_handle_, service_handle_;
  ros::Publisher odometry_pub_, motor_speed_pub_, relay_pub_, clock_pub_, tf_pub_;
  std::vector<std::pair<const SensorModel*, ros::Publisher>> other_odometry_;
  std::vector<ros::Publisher> rotor_pubs_;
  ros::Subscriber command_sub_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner service_spinner_;
  std::thread runner_;
};

}  // namespace quad_sim
