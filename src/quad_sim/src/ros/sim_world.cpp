#include "sim_world.hpp"

#include <gazebo_msgs/ModelStates.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

#include "model_state.hpp"
#include "quad_sim_ros/conversions.hpp"
#include "world_state.hpp"

namespace quad_sim {

SimWorld::SimWorld(const std::vector<VehicleSpec>& fleet, const SimNodeOptions& options)
    : options_(options),
      pacer_(gate_, fleet.at(0).config.options.step, options.real_time_factor, [this](std::int64_t n) { run(n); }) {
  constexpr int kQueueLength = 10;
  clock_pub_ = handle_.advertise<rosgraph_msgs::Clock>("/clock", kQueueLength, true);
  models_pub_ = handle_.advertise<gazebo_msgs::ModelStates>("/gazebo/model_states", kQueueLength);
  const WorldGate::Visit visit(gate_);  // commands that come meanwhile wait
  handle_.setCallbackQueue(&topic_queue_);
  for (const VehicleSpec& spec : fleet) {
    vehicles_.push_back(std::make_unique<Vehicle>(spec, gate_, [this] { return running(); }, handle_));
  }
  publish();
  pacer_.setRunning(!options.paused);
}

SimWorld::~SimWorld() {
  for (auto& vehicle : vehicles_) vehicle->commands.stop();
  const WorldGate::Visit visit(gate_);
  pacer_.setRunning(false);
}

void SimWorld::stopWaiting() {
  for (auto& vehicle : vehicles_) vehicle->commands.inbox().stop();
}

Vehicle* SimWorld::find(const std::string& name) {
  Vehicle* found = nullptr;
  for (auto& vehicle : vehicles_) {
    if (vehicle->name == name) return vehicle.get();
    if (vehicle->simulator.model().name != name) continue;
    if (found) return nullptr;
    found = vehicle.get();
  }
  return found;
}

void SimWorld::advance(std::int64_t steps) {
  while (steps > 0) {
    const std::int64_t now = first().simulator.stepCount();
    std::int64_t chunk = std::min<std::int64_t>(steps, 1000000000);
    for (auto& vehicle : vehicles_) chunk = std::min(chunk, vehicle->topics.nextEvent() - now);
    for (auto& vehicle : vehicles_) {
      const std::int64_t event = vehicle->topics.nextEvent();
      vehicle->simulator.advance(static_cast<int>(chunk));
      if (event == now + chunk) vehicle->topics.atEvent();
    }
    steps -= chunk;
  }
}

void SimWorld::publish() {
  rosgraph_msgs::Clock clock;
  clock.clock = toStamp(timeNanoseconds());
  clock_pub_.publish(clock);
  for (auto& vehicle : vehicles_) vehicle->publish();
  if (models_pub_.getNumSubscribers() > 0) publishModelStates();
}

void SimWorld::publishModelStates() {
  gazebo_msgs::ModelStates states;
  for (const auto& vehicle : vehicles_) {
    const ModelState state = modelState(vehicle->simulator.state());
    states.name.push_back(vehicle->name);
    states.pose.push_back(poseMsg(state));
    states.twist.push_back(twistMsg(state));
  }
  models_pub_.publish(states);
}

void SimWorld::setRunning(bool running) {
  if (running == pacer_.running()) return;
  if (running) {
    for (auto& vehicle : vehicles_) vehicle->commands.flyLatest();
  } else {
    publish();  // the state it stopped in, exactly
  }
  pacer_.setRunning(running);
}

void SimWorld::reset(bool time_too) {
  for (auto& vehicle : vehicles_) vehicle->reset(time_too);
  publish();
}

void SimWorld::setPhysics(double step, double gravity, double real_time_factor) {
  const double before = this->step();
  for (auto& vehicle : vehicles_) vehicle->simulator.setPhysics(step, gravity);  // all the same: the first refuses for all
  for (auto& vehicle : vehicles_) vehicle->topics.renew();
  pacer_.setRate(step, real_time_factor);
  if (options_.publish_every > 0) {
    options_.publish_every = static_cast<int>(std::max(1.0, std::round(options_.publish_every * before / step)));
  }
}

std::string SimWorld::save() { return saveWorld(vehicles_); }

void SimWorld::restore(const std::string& state) {
  restoreWorld(vehicles_, state);
  for (auto& vehicle : vehicles_) vehicle->commands.clear();
  publish();
}

void SimWorld::run(std::int64_t steps) {
  while (steps > 0) {
    std::int64_t chunk = steps;
    const std::int64_t every = options_.publish_every;
    if (every > 0) chunk = std::min(chunk, every - first().simulator.stepCount() % every);
    advance(chunk);
    if (every > 0 && first().simulator.stepCount() % every == 0) publish();
    steps -= chunk;
  }
}

}  // namespace quad_sim
