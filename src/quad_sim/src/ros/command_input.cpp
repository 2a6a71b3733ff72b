#include "command_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "quad_sim_ros/conversions.hpp"
#include "quad_support/number_format.hpp"
#include "vehicle_topics.hpp"

namespace quad_sim {

CommandInput::CommandInput(Simulator& simulator, const std::string& name, WorldGate& gate,
                           std::function<bool()> running, ros::NodeHandle& handle)
    : simulator_(simulator),
      unchecked_(simulator.options().allQuirks().unchecked_commands),
      name_(name),
      gate_(gate),
      running_(std::move(running)) {
  for (const RotorModel& rotor : simulator.model().rotors) max_speed_.push_back(rotor.max_speed);
  constexpr int kQueueLength = 10;
  const std::string ns = "/" + name + "/";
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  command_sub_ = handle.subscribe(ns + "command/motor_speed", kQueueLength,
                                  &CommandInput::onCommand, this, hints);
  relay_sub_ = handle.subscribe(ns + "gazebo/command/motor_speed", kQueueLength,
                                &CommandInput::onRelayed, this, hints);
  wind_sub_ =
      handle.subscribe(ns + windSpeedTopic(simulator.model()), 1, &CommandInput::onWind, this);
}

void CommandInput::stop() {
  command_sub_.shutdown();
  relay_sub_.shutdown();
  wind_sub_.shutdown();
  inbox_.stop();
}

void CommandInput::clear() {
  inbox_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  tally_ = {};
  newest_answered_ = 0;
}

CommandTally CommandInput::tally() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tally_;
}

void CommandInput::flyLatest() {
  const auto command = inbox_.latest();
  if (command) simulator_.setCommand(command->rotor_speed);
}

std::string CommandInput::problemOf(const mav_msgs::Actuators& message) {
  const std::vector<double>& speeds = message.angular_velocities;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++tally_.received;
  if (speeds.size() != max_speed_.size()) {
    ++tally_.wrong_length;
    return tally_.last_problem = fmt::format("{} rotor speeds; the vehicle has {} rotors",
                                             speeds.size(), max_speed_.size());
  }
  const bool finite =
      std::all_of(speeds.begin(), speeds.end(), [](double w) { return std::isfinite(w); });
  if (!finite) {
    ++tally_.not_finite;
    tally_.last_problem = "a rotor speed is not a finite number";
    return unchecked_ ? "" : tally_.last_problem;
  }
  const std::int64_t stamp = toNanoseconds(message.header.stamp);
  if (stamp != 0 && stamp < newest_answered_) {
    ++tally_.late;
    return tally_.last_problem = fmt::format(
               "late: it answers the odometry of {} s, that of {} s is answered already",
               quad_support::shortest(1e-9 * static_cast<double>(stamp)),
               quad_support::shortest(1e-9 * static_cast<double>(newest_answered_)));
  }
  if (stamp <= newest_odometry_) newest_answered_ = std::max(newest_answered_, stamp);
  bool negative = false, over = false;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    negative = negative || speeds[i] < 0;
    over = over || speeds[i] > max_speed_[i];
  }
  tally_.negative += negative ? 1 : 0;
  tally_.over_limit += over ? 1 : 0;
  if (negative) tally_.last_problem = "a rotor speed is negative: flown as 0";
  if (over) tally_.last_problem = "a rotor speed is above the rotor's maximum: flown as that";
  return "";
}

void CommandInput::onCommand(const mav_msgs::Actuators& message) {
  const ArrivedCommand command{message.angular_velocities, problemOf(message)};
  const bool usable = command.problem.empty();
  if (!usable) {
    ROS_ERROR_THROTTLE(1.0, "/%s/command/motor_speed refused: %s; the earlier command stays",
                       name_.c_str(), command.problem.c_str());
  }
  inbox_.put(toNanoseconds(message.header.stamp), command);
  if (!running_()) return;  // flyLatest() takes it when the world starts to run
  const WorldGate::Visit visit(gate_);
  if (running_() && usable) simulator_.setCommand(command.rotor_speed);
}

void CommandInput::onRelayed(const ros::MessageEvent<const mav_msgs::Actuators>& event) {
  if (event.getPublisherName() != ros::this_node::getName()) onCommand(*event.getMessage());
}

void CommandInput::onWind(const ros::MessageEvent<const rotors_comm::WindSpeed>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  const auto& v = event.getMessage()->velocity;
  const WorldGate::Visit visit(gate_);
  try {
    simulator_.setWind({v.x, v.y, v.z});
  } catch (const std::invalid_argument& e) {
    ROS_ERROR_THROTTLE(1.0, "/%s/wind_speed refused: %s; the earlier wind stays", name_.c_str(),
                       e.what());
  }
}

}  // namespace quad_sim
