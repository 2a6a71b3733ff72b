#include "sim_world.hpp"

#include <fmt/core.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

#include "quad_sim/plugin.hpp"
#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

SimWorld::SimWorld(const SimulationConfig& config, const SimNodeOptions& options)
    : config_(config),
      options_(options),
      simulator_(makeSimulator(config, loadVehicle(config))),
      topics_(simulator_, config.vehicle_namespace, handle_),
      pacer_(gate_, config.options.step, options.real_time_factor,
             [this](std::int64_t steps) { run(steps); }) {
  for (const std::string& plugin : ignoredPlugins(simulator_.model())) {
    ROS_INFO("without effect in this version: %s", plugin.c_str());
  }
  constexpr int kQueueLength = 10;
  clock_pub_ = handle_.advertise<rosgraph_msgs::Clock>("/clock", kQueueLength, true);
  const WorldGate::Visit visit(gate_);
  handle_.setCallbackQueue(&topic_queue_);
  command_sub_ = handle_.subscribe("/" + vehicleName() + "/command/motor_speed", kQueueLength,
                                   &SimWorld::onCommand, this, ros::TransportHints().tcpNoDelay());
  publish();
  pacer_.setRunning(!options.paused);
}

SimWorld::~SimWorld() {
  command_sub_.shutdown();  // no callback from here on
  inbox_.stop();
}

void SimWorld::onCommand(const mav_msgs::Actuators& message) {
  ArrivedCommand command{message.angular_velocities, ""};
  const std::size_t rotors = simulator_.model().rotors.size();
  const bool finite = std::all_of(command.rotor_speed.begin(), command.rotor_speed.end(),
                                  [](double w) { return std::isfinite(w); });
  if (command.rotor_speed.size() != rotors) {
    command.problem = fmt::format("{} rotor speeds; the vehicle has {} rotors",
                                  command.rotor_speed.size(), rotors);
  } else if (!finite) {
    command.problem = "a rotor speed is not a finite number";
  }
  if (!command.problem.empty()) {
    ROS_ERROR_THROTTLE(1.0, "/%s/command/motor_speed refused: %s; the earlier command stays",
                       vehicleName().c_str(), command.problem.c_str());
  }
  inbox_.put(toNanoseconds(message.header.stamp), command);
  if (!running()) return;  // setRunning() takes the latest from the inbox
  const WorldGate::Visit visit(gate_);
  if (running() && command.problem.empty()) simulator_.setCommand(command.rotor_speed);
}

bool SimWorld::isModel(const std::string& name) const {
  return name == vehicleName() || name == simulator_.model().name;
}

void SimWorld::publish() {
  rosgraph_msgs::Clock clock;
  clock.clock = toStamp(simulator_.timeNanoseconds());
  clock_pub_.publish(clock);
  topics_.publish();
}

void SimWorld::setRunning(bool running) {
  if (running == pacer_.running()) return;
  if (running) {
    const auto command = inbox_.latest();
    if (command && command->problem.empty()) simulator_.setCommand(command->rotor_speed);
  } else {
    publish();  // the state it stopped in, exactly
  }
  pacer_.setRunning(running);
}

void SimWorld::reset(bool time_too) {
  inbox_.clear();
  time_too ? simulator_.reset() : simulator_.resetWorld();
  publish();
}

void SimWorld::run(std::int64_t steps) {
  while (steps > 0) {
    std::int64_t chunk = steps;
    const std::int64_t every = options_.odometry_every;
    if (every > 0) chunk = std::min(chunk, every - simulator_.stepCount() % every);
    simulator_.advance(static_cast<int>(chunk));
    if (every > 0 && simulator_.stepCount() % every == 0) publish();
    steps -= chunk;
  }
}

}  // namespace quad_sim
