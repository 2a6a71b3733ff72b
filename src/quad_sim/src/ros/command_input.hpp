/// What comes in for one vehicle: rotor speeds and wind.
#pragma once

#include <mav_msgs/Actuators.h>
#include <ros/ros.h>
#include <rotors_comm/WindSpeed.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "command_inbox.hpp"
#include "quad_sim/simulator.hpp"
#include "world_gate.hpp"

namespace quad_sim {

/// What has become of the commands since the last reset.
struct CommandTally {
  std::uint64_t received = 0, wrong_length = 0, not_finite = 0, late = 0, negative = 0,
                over_limit = 0;
  std::string last_problem;
};

/// Takes commands from <ns>/command/motor_speed, and from <ns>/gazebo/command/motor_speed if others
/// speak there; wind from <ns>/wind_speed.
///
/// While the world is paused a command waits for the Step that asks for its stamp; while it runs a
/// command acts from the next physics step on. Of the wrong length, with a speed that is no number,
/// or late: refused, the earlier command stays. Negative or above the rotor's maximum: flown as the
/// limit (the simulator clamps it). Late is a command that answers an odometry older than one
/// answered already; a stamp of zero or of the future answers none and is never late.
class CommandInput {
 public:
  CommandInput(Simulator& simulator, const std::string& name, WorldGate& gate,
               std::function<bool()> running, ros::NodeHandle& handle);
  ~CommandInput() { stop(); }
  void stop();  ///< no callback from here on, and whoever waits for a command is told so

  CommandInbox& inbox() { return inbox_; }
  void clear();      ///< forgets what arrived, and the tally
  void flyLatest();  ///< hands the latest usable command to the simulator
  void published(std::int64_t stamp_ns) { newest_odometry_ = stamp_ns; }
  CommandTally tally() const;

 private:
  void onCommand(const mav_msgs::Actuators& message);
  void onRelayed(const ros::MessageEvent<const mav_msgs::Actuators>& event);
  void onWind(const ros::MessageEvent<const rotors_comm::WindSpeed>& event);
  std::string problemOf(const mav_msgs::Actuators& message);  ///< also counts

  Simulator& simulator_;
  std::vector<double>
      max_speed_;   ///< of the rotors: the simulator itself is for within a visit to the gate
  bool unchecked_;  ///< RotorS's way: what is no number is flown, too
  std::string name_;
  WorldGate& gate_;
  std::function<bool()> running_;
  CommandInbox inbox_;
  std::atomic<std::int64_t> newest_odometry_{0};
  mutable std::mutex mutex_;  ///< of the tally and newest_answered_
  CommandTally tally_;
  std::int64_t newest_answered_ = 0;
  ros::Subscriber command_sub_, relay_sub_, wind_sub_;
};

}  // namespace quad_sim
