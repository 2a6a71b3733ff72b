#include "sim_world.hpp"

#include <fmt/core.h>
#include <gazebo_msgs/LinkStates.h>
#include <gazebo_msgs/ModelStates.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>

#include "quad_sim_ros/conversions.hpp"
#include "world_state.hpp"

namespace quad_sim {

SimWorld::SimWorld(const std::vector<VehicleSpec>& fleet, const SimNodeOptions& options,
                   const ros::NodeHandle& services)
    : options_(options),
      services_(services),
      pacer_(gate_, fleet.at(0).options.step, options.real_time_factor,
             [this](std::int64_t n) { run(n); }) {
  constexpr int kQueueLength = 10;
  clock_pub_ = handle_.advertise<rosgraph_msgs::Clock>("/clock", kQueueLength, true);
  models_pub_ = handle_.advertise<gazebo_msgs::ModelStates>("/gazebo/model_states", kQueueLength);
  links_pub_ = handle_.advertise<gazebo_msgs::LinkStates>("/gazebo/link_states", kQueueLength);
  const WorldGate::Visit visit(gate_);  // commands that come meanwhile wait
  handle_.setCallbackQueue(&topic_queue_);
  for (const VehicleSpec& spec : fleet)
    vehicles_.push_back(std::make_unique<Vehicle>(spec, surroundings()));
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

bool isWorld(const std::string& frame) {
  return frame.empty() || frame == "world" || frame == "map" || frame == "/map";
}

std::string SimWorld::nobody(const std::string& name) const {
  std::string there;
  for (const auto& vehicle : vehicles_)
    there += (there.empty() ? "'" : ", '") + vehicle->name + "'";
  return fmt::format("no model '{}'; in the world there is {}", name, there);
}

std::vector<const LinkModel*> bodies(const VehicleModel& model) {
  std::vector<const LinkModel*> out;
  for (const LinkModel& link : model.links) {
    if (!link.on_base || link.name == model.base_link) out.push_back(&link);
  }
  return out;
}

ModelState linkState(const Vehicle& vehicle, const LinkModel& link) {
  const VehicleState state = vehicle.simulator.state();
  for (const RotorModel& rotor : vehicle.simulator.model().rotors) {
    if (rotor.link != link.name) continue;
    const JointMotion joint = jointMotion(vehicle, rotor);
    return linkState(state, link, rotor.axis_B, joint.angle, joint.speed);
  }
  return linkState(state, link);
}

namespace {

const LinkModel* linkNamed(const VehicleModel& model, const std::string& name) {
  for (const LinkModel& link : model.links) {
    if (link.name == name || link.name.substr(link.name.rfind('/') + 1) == name) return &link;
  }
  return nullptr;
}

}  // namespace

LinkOf SimWorld::findLink(const std::string& name) {
  const auto colons = name.find("::");
  if (colons != std::string::npos) {
    Vehicle* const vehicle = find(name.substr(0, colons));
    const LinkModel* const link =
        vehicle ? linkNamed(vehicle->simulator.model(), name.substr(colons + 2)) : nullptr;
    return link ? LinkOf{vehicle, link} : LinkOf{};
  }
  LinkOf found;
  for (auto& vehicle : vehicles_) {
    const LinkModel* const link = linkNamed(vehicle->simulator.model(), name);
    if (link && found.link) return {};
    if (link) found = {vehicle.get(), link};
  }
  return found;
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

void SimWorld::add(const VehicleSpec& spec) {
  auto vehicle = std::make_unique<Vehicle>(spec, surroundings());
  SavedState at_start = vehicle->simulator.save();
  at_start.step_count = first().simulator.stepCount();
  vehicle->simulator.restore(at_start);
  vehicle->topics.start();
  vehicles_.push_back(std::move(vehicle));
  publish();
}

void SimWorld::remove(Vehicle& vehicle) {
  vehicle.commands.stop();  // before the visit, for it waits for callbacks, and they for the gate
  std::unique_ptr<Vehicle> gone;
  const auto here = std::find_if(vehicles_.begin(), vehicles_.end(),
                                 [&](const auto& v) { return v.get() == &vehicle; });
  {
    const WorldGate::Visit visit(gate_);
    gone = std::move(*here);
    vehicles_.erase(here);
    publish();
  }
}

void SimWorld::advance(std::int64_t steps) {
  while (steps > 0) {
    const std::int64_t now = first().simulator.stepCount();
    std::int64_t chunk = std::min<std::int64_t>(steps, 1000000000);
    for (auto& vehicle : vehicles_) chunk = std::min(chunk, vehicle->nextEvent() - now);
    for (auto& vehicle : vehicles_) {
      const std::int64_t event = vehicle->nextEvent();
      vehicle->simulator.advance(static_cast<int>(chunk));
      if (event == now + chunk) vehicle->atEvent();
    }
    steps -= chunk;
  }
}

void SimWorld::publish() {
  rosgraph_msgs::Clock clock;
  clock.clock = toStamp(timeNanoseconds());
  clock_pub_.publish(clock);
  for (auto& vehicle : vehicles_) vehicle->publish();
  speedometer_.publish(timeNanoseconds());
  if (models_pub_.getNumSubscribers() > 0) publishModelStates();
  if (links_pub_.getNumSubscribers() > 0) publishLinkStates();
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

void SimWorld::publishLinkStates() {
  gazebo_msgs::LinkStates states;
  const auto tell = [&](const std::string& name, const ModelState& state) {
    states.name.push_back(name);
    states.pose.push_back(poseMsg(state));
    states.twist.push_back(twistMsg(state));
  };
  if (ground()) tell("ground_plane::link", modelState(VehicleState()));
  for (const auto& vehicle : vehicles_) {
    for (const LinkModel* link : bodies(vehicle->simulator.model())) {
      tell(vehicle->name + "::" + link->name, linkState(*vehicle, *link));
    }
  }
  links_pub_.publish(states);
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
  for (auto& vehicle : vehicles_)
    vehicle->simulator.setPhysics(step, gravity);  // all the same: the first refuses for all
  for (auto& vehicle : vehicles_) vehicle->topics.renew();
  pacer_.setRate(step, real_time_factor);
  if (options_.publish_every > 0) {
    options_.publish_every =
        static_cast<int>(std::max(1.0, std::round(options_.publish_every * before / step)));
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
