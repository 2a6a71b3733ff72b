/// The simulator's services as the time manager calls them: persistent connections, one careful
/// retry.
#pragma once

#include <quad_sim/Step.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include <string>

namespace quad_control {

/// All functions throw quad_support::EnvironmentError when the simulator cannot be reached or
/// refuses.
class SimulatorClient {
 public:
  /// Waits until /gazebo/step is offered, at most `timeout` [s] of wall time.
  void waitUntilThere(double timeout);
  void pause() { callEmpty(pause_, "/gazebo/pause_physics"); }
  void unpause() { callEmpty(unpause_, "/gazebo/unpause_physics"); }
  /// Resets the simulator, and from the second time on restores the state of the first: with
  /// quad_sim's quirk filter_survives_reset a reset alone would not make two flights alike.
  void startAfresh();

  /// One /gazebo/step. Where the connection breaks in between, the state is read again, and only a
  /// step that has not been made is repeated. @param before_ns  simulated time before the step
  quad_sim::Step::Response step(const quad_sim::Step::Request& request, std::int64_t before_ns);
  /// The present state; waits for the command stamped `command_stamp` unless that is zero.
  quad_sim::Step::Response read(const ros::Time& command_stamp, double timeout);

 private:
  bool restoreStart();
  void callEmpty(ros::ServiceClient& client, const std::string& name);
  bool tryStep(quad_sim::Step& call);

  ros::ServiceClient pause_, unpause_, reset_, save_, restore_, step_;
  std::string start_;  ///< saved state after the first reset
};

}  // namespace quad_control
