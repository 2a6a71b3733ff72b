#include "sim_node.hpp"

#include <fmt/core.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Float32.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "quad_sim_ros/conversions.hpp"
#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kQueueLength = 10;

std::string inSeconds(std::int64_t ns) { return quad_support::shortest(static_cast<double>(ns) * 1e-9) + " s"; }

/// Takes the mutex and tells the running loop that somebody wants it.
class Visit {
 public:
  Visit(std::mutex& mutex, std::atomic<int>& waiting) : waiting_(waiting), lock_(mutex, std::defer_lock) {
    ++waiting_;
    lock_.lock();
  }
  ~Visit() { --waiting_; }

 private:
  std::atomic<int>& waiting_;
  std::unique_lock<std::mutex> lock_;
};

}  // namespace

SimNode::SimNode(const SimulationConfig& config, const SimNodeOptions& options)
    : config_(config),
      options_(options),
      model_(loadVehicle(config)),
      simulator_(makeSimulator(config, model_)),
      ns_("/" + config.vehicle_namespace + "/"),
      service_spinner_(1, &service_queue_) {
  const auto is_odometry = [](const SensorModel& s) { return s.kind == SensorModel::Kind::kOdometry; };
  const auto first = std::find_if(model_.sensors.begin(), model_.sensors.end(), is_odometry);
  if (first == model_.sensors.end()) {
    throw std::invalid_argument(config.urdf + ": no odometry sensor; controllers over ROS need one "
                                "(librotors_gazebo_odometry_plugin.so)");
  }
  primary_ = &*first;
  topic_handle_.setCallbackQueue(&command_queue_);
  service_handle_.setCallbackQueue(&service_queue_);
  running_ = !options.paused;
  for (const std::string& plugin : ignoredPlugins(model_)) {
    ROS_INFO("without effect in this version: %s", plugin.c_str());
  }
  advertise();
  publish();
  service_spinner_.start();
  runner_ = std::thread([this] { runLoop(); });
}

SimNode::~SimNode() {
  command_sub_.shutdown();  // no callback from here on
  inbox_.stop();
  {
    const Visit visit(mutex_, waiting_);
    stop_ = true;
  }
  state_changed_.notify_all();
  runner_.join();
  service_spinner_.stop();
}

void SimNode::advertise() {
  ros::NodeHandle& n = topic_handle_;
  odometry_pub_ = n.advertise<nav_msgs::Odometry>(ns_ + primary_->topic, kQueueLength, true);
  motor_speed_pub_ = n.advertise<mav_msgs::Actuators>(ns_ + "motor_speed", kQueueLength, true);
  relay_pub_ = n.advertise<mav_msgs::Actuators>(ns_ + "gazebo/command/motor_speed", kQueueLength);
  clock_pub_ = n.advertise<rosgraph_msgs::Clock>("/clock", kQueueLength, true);
  tf_pub_ = n.advertise<tf2_msgs::TFMessage>("/tf", 100);
  for (const SensorModel& sensor : model_.sensors) {
    if (sensor.kind != SensorModel::Kind::kOdometry || &sensor == primary_) continue;
    other_odometry_.emplace_back(&sensor, n.advertise<nav_msgs::Odometry>(ns_ + sensor.topic, kQueueLength));
  }
  for (const RotorModel& rotor : model_.rotors) {
    rotor_pubs_.push_back(n.advertise<std_msgs::Float32>(fmt::format("{}motor_speed/{}", ns_, rotor.motor_number),
                                                         kQueueLength));
  }
  command_sub_ = n.subscribe(ns_ + "command/motor_speed", kQueueLength, &SimNode::onCommand, this,
                             ros::TransportHints().tcpNoDelay());
  ros::NodeHandle& s = service_handle_;
  services_ = {
      s.advertiseService("/gazebo/step", &SimNode::onStep, this),
      s.advertiseService("/gazebo/pause_physics", &SimNode::onPause, this),
      s.advertiseService("/gazebo/unpause_physics", &SimNode::onUnpause, this),
      s.advertiseService("/gazebo/reset_world", &SimNode::onResetWorld, this),
      s.advertiseService("/gazebo/reset_simulation", &SimNode::onResetSimulation, this),
      s.advertiseService("/gazebo/get_model_state", &SimNode::onGetModelState, this),
      s.advertiseService("/gazebo/set_model_state", &SimNode::onSetModelState, this),
      s.advertiseService("/gazebo/get_world_properties", &SimNode::onGetWorldProperties, this),
      s.advertiseService("/gazebo/get_physics_properties", &SimNode::onGetPhysicsProperties, this),
  };
}

void SimNode::onCommand(const mav_msgs::Actuators& message) {
  ArrivedCommand command{message.angular_velocities, ""};
  const bool finite = std::all_of(command.rotor_speed.begin(), command.rotor_speed.end(),
                                  [](double w) { return std::isfinite(w); });
  if (command.rotor_speed.size() != model_.rotors.size()) {
    command.problem = fmt::format("{} rotor speeds; the vehicle has {} rotors", command.rotor_speed.size(),
                                  model_.rotors.size());
  } else if (!finite) {
    command.problem = "a rotor speed is not a finite number";
  }
  if (!command.problem.empty()) {
    ROS_ERROR_THROTTLE(1.0, "%scommand/motor_speed refused: %s; the earlier command stays", ns_.c_str(),
                       command.problem.c_str());
  }
  inbox_.put(toNanoseconds(message.header.stamp), command);
  if (!running_) return;  // onUnpause() takes the latest from the inbox
  const Visit visit(mutex_, waiting_);
  if (running_ && command.problem.empty()) simulator_.setCommand(command.rotor_speed);
}

// ---- what is published ----

void SimNode::publish() {
  const std::int64_t now = simulator_.timeNanoseconds();
  const Measurement measured = simulator_.measure();
  last_odometry_ = toMsg(simulator_.odometry(*primary_), primary_->frame);
  last_motor_speed_ = toMsg(measured.rotor_speed, model_, now, config_.vehicle_namespace + "/base_link");
  rosgraph_msgs::Clock clock;
  clock.clock = toStamp(now);
  clock_pub_.publish(clock);
  motor_speed_pub_.publish(last_motor_speed_);
  odometry_pub_.publish(last_odometry_);  // after the motor speeds: controllers start on the odometry
  publishOthers(measured);
}

/// What only matters to those who listen.
void SimNode::publishOthers(const Measurement& measured) {
  if (relay_pub_.getNumSubscribers() > 0) {
    mav_msgs::Actuators relay;
    relay.header.stamp = last_odometry_.header.stamp;
    relay.angular_velocities = simulator_.command();
    relay_pub_.publish(relay);
  }
  for (auto& [sensor, publisher] : other_odometry_) {
    if (publisher.getNumSubscribers() > 0) publisher.publish(toMsg(simulator_.odometry(*sensor), sensor->frame));
  }
  for (std::size_t i = 0; i < rotor_pubs_.size(); ++i) {
    if (rotor_pubs_[i].getNumSubscribers() == 0) continue;
    const RotorModel& rotor = model_.rotors[i];
    std_msgs::Float32 joint_speed;  // RotorS publishes the slowed joint's speed here
    joint_speed.data = static_cast<float>(rotor.spin * measured.rotor_speed[i] / rotor.slowdown);
    rotor_pubs_[i].publish(joint_speed);
  }
  if (tf_pub_.getNumSubscribers() == 0) return;
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(toTransform(last_odometry_));
  for (auto& entry : other_odometry_) {
    transforms.transforms.push_back(toTransform(toMsg(simulator_.odometry(*entry.first), entry.first->frame)));
  }
  tf_pub_.publish(transforms);
}

// ---- lock-step ----

std::string SimNode::groundMessage() const {
  const auto contact = simulator_.groundContactTime();
  return contact ? "ground contact at " + inSeconds(*contact) : "";
}

std::string SimNode::runStep(const Step::Request& request) {
  constexpr std::uint32_t kMaxSteps = 1000000000;  // keeps a negative number sent as unsigned from running for days
  if (request.steps > kMaxSteps) return fmt::format("steps = {}; must be <= {}", request.steps, kMaxSteps);
  if (request.hold_steps > request.steps) {
    return fmt::format("hold_steps = {}; must be <= steps = {}", request.hold_steps, request.steps);
  }
  if (!(request.timeout >= 0 && request.timeout <= CommandInbox::kLongestWait)) {
    return fmt::format("timeout = {} s; must lie in [0, {}] s", quad_support::shortest(request.timeout),
                       CommandInbox::kLongestWait);
  }
  constexpr double kDefaultTimeout = 10.0;  // [s]
  const double timeout = request.timeout > 0 ? request.timeout : kDefaultTimeout;
  const std::int64_t stamp = toNanoseconds(request.command_stamp);
  const auto command = stamp == 0 ? inbox_.latest() : inbox_.waitFor(stamp, timeout);
  if (stamp != 0 && !command) {
    return fmt::format("no command stamped {}.{:09} s on {}command/motor_speed within {} s", request.command_stamp.sec,
                       request.command_stamp.nsec, ns_, quad_support::shortest(timeout));
  }
  const bool usable = command && command->problem.empty();
  if (stamp != 0 && !usable) return "the command was refused: " + command->problem;
  const Visit visit(mutex_, waiting_);
  if (running_) return "the physics is running; call /gazebo/pause_physics first";
  simulator_.advance(static_cast<int>(request.hold_steps));
  if (usable && request.steps > 0) simulator_.setCommand(command->rotor_speed);
  simulator_.advance(static_cast<int>(request.steps - request.hold_steps));
  publish();
  return "";
}

bool SimNode::onStep(Step::Request& request, Step::Response& response) {
  try {
    {
      const Visit visit(mutex_, waiting_);  // asked before waiting for a command, for it may never come while running
      if (running_) {
        response.message = "the physics is running; call /gazebo/pause_physics first";
        return true;
      }
    }
    response.message = runStep(request);
    response.success = response.message.empty();
  } catch (const quad_support::SimulationError& e) {
    response.message = std::string("simulation failed: ") + e.what();
  }
  const Visit visit(mutex_, waiting_);
  if (response.success) response.message = groundMessage();
  response.stamp = toTime(simulator_.timeNanoseconds());
  response.odometry = last_odometry_;
  response.motor_speed = last_motor_speed_;
  return true;
}

// ---- running by the clock on the wall ----

bool SimNode::onPause(Empty::Request&, Empty::Response&) {
  const Visit visit(mutex_, waiting_);
  if (running_) publish();  // the state it stopped in, exactly
  running_ = false;
  return true;
}

bool SimNode::onUnpause(Empty::Request&, Empty::Response&) {
  {
    const Visit visit(mutex_, waiting_);
    if (running_) return true;
    running_ = true;
    const auto command = inbox_.latest();
    if (command && command->problem.empty()) simulator_.setCommand(command->rotor_speed);
  }
  state_changed_.notify_all();
  return true;
}

void SimNode::runSteps(std::int64_t steps) {
  while (steps > 0) {
    std::int64_t chunk = steps;
    const std::int64_t every = options_.odometry_every;
    if (every > 0) chunk = std::min(chunk, every - simulator_.stepCount() % every);
    simulator_.advance(static_cast<int>(chunk));
    if (every > 0 && simulator_.stepCount() % every == 0) publish();
    steps -= chunk;
  }
}

/// Runs what is due since `since`, of which `done` steps are done already. Returns the steps done then.
std::int64_t SimNode::runDue(Clock::time_point since, std::int64_t done) {
  const double step = static_cast<double>(simulator_.stepNanoseconds()) * 1e-9;
  // At most this much at a time, so that callers get in between: about 10 ms of simulated time.
  const std::int64_t most = std::max<std::int64_t>(1, std::llround(0.01 / step));
  std::int64_t due = most;
  if (options_.real_time_factor > 0) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - since).count();
    due = static_cast<std::int64_t>(elapsed * options_.real_time_factor / step) - done;
  }
  const std::int64_t steps = std::clamp<std::int64_t>(due, 0, most);
  runSteps(steps);
  return done + steps;
}

void SimNode::runLoop() {
  constexpr auto kNap = std::chrono::microseconds(500);  // half of the usual physics step
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stop_) {
    state_changed_.wait(lock, [this] { return running_ || stop_; });
    const auto since = Clock::now();
    std::int64_t done = 0;
    while (running_ && !stop_) {
      try {
        done = runDue(since, done);
      } catch (const quad_support::SimulationError& e) {
        ROS_FATAL("%s; paused", e.what());
        running_ = false;
      }
      lock.unlock();
      if (options_.real_time_factor > 0) std::this_thread::sleep_for(kNap);
      while (waiting_.load() > 0) std::this_thread::yield();
      lock.lock();
    }
  }
}

// ---- state and properties ----

void SimNode::reset(bool time_too) {
  const Visit visit(mutex_, waiting_);
  inbox_.clear();
  time_too ? simulator_.reset() : simulator_.resetWorld();
  publish();
}

bool SimNode::onResetWorld(Empty::Request&, Empty::Response&) {
  reset(false);
  return true;
}

bool SimNode::onResetSimulation(Empty::Request&, Empty::Response&) {
  reset(true);
  return true;
}

bool SimNode::isModel(const std::string& name) const { return name == config_.vehicle_namespace || name == model_.name; }

namespace {

bool isWorld(const std::string& frame) { return frame.empty() || frame == "world" || frame == "map" || frame == "/map"; }

}  // namespace

bool SimNode::onGetModelState(gazebo_msgs::GetModelState::Request& request,
                              gazebo_msgs::GetModelState::Response& response) {
  if (!isModel(request.model_name) || !isWorld(request.relative_entity_name)) {
    response.status_message = fmt::format("no model '{}' relative to '{}'; there is '{}' in the world", request.model_name,
                                          request.relative_entity_name, config_.vehicle_namespace);
    return true;
  }
  const Visit visit(mutex_, waiting_);
  const Measurement measured = simulator_.measure();
  const VehicleState state = simulator_.state();
  const nav_msgs::Odometry odometry = toMsg(measured.odometry, "");
  const Eigen::Vector3d w_W = state.q_WB * state.w_WB_B;
  response.header.seq = ++sequence_;
  response.header.stamp = odometry.header.stamp;
  response.header.frame_id = "world";
  response.pose = odometry.pose.pose;
  response.twist.linear.x = state.v_WB.x();
  response.twist.linear.y = state.v_WB.y();
  response.twist.linear.z = state.v_WB.z();
  response.twist.angular.x = w_W.x();
  response.twist.angular.y = w_W.y();
  response.twist.angular.z = w_W.z();
  response.success = true;
  response.status_message = "GetModelState: got properties";
  return true;
}

bool SimNode::onSetModelState(gazebo_msgs::SetModelState::Request& request,
                              gazebo_msgs::SetModelState::Response& response) {
  const gazebo_msgs::ModelState& wanted = request.model_state;
  if (!isModel(wanted.model_name) || !isWorld(wanted.reference_frame)) {
    response.status_message = fmt::format("no model '{}' with reference '{}'; there is '{}' in the world",
                                          wanted.model_name, wanted.reference_frame, config_.vehicle_namespace);
    return true;
  }
  const Visit visit(mutex_, waiting_);
  try {
    nav_msgs::Odometry as_odometry;
    as_odometry.pose.pose = wanted.pose;
    as_odometry.twist.twist = wanted.twist;
    const Odometry given = fromMsg(as_odometry);  // here the twist is in world axes
    VehicleState state = simulator_.state();
    state.p_WB = given.p_WB;
    state.q_WB = given.q_WB;
    state.v_WB = given.v_WB_B;
    state.w_WB_B = given.q_WB.normalized().conjugate() * given.w_WB_B;
    simulator_.setState(state);
    publish();
    response.success = true;
    response.status_message = "SetModelState: set model state done";
  } catch (const std::invalid_argument& e) {
    response.status_message = e.what();
  }
  return true;
}

bool SimNode::onGetWorldProperties(gazebo_msgs::GetWorldProperties::Request&,
                                   gazebo_msgs::GetWorldProperties::Response& response) {
  const Visit visit(mutex_, waiting_);
  response.sim_time = static_cast<double>(simulator_.timeNanoseconds()) * 1e-9;
  if (config_.options.ground) response.model_names.push_back("ground_plane");
  response.model_names.push_back(config_.vehicle_namespace);
  response.rendering_enabled = false;
  response.success = true;
  response.status_message = "GetWorldProperties: got properties";
  return true;
}

bool SimNode::onGetPhysicsProperties(gazebo_msgs::GetPhysicsProperties::Request&,
                                     gazebo_msgs::GetPhysicsProperties::Response& response) {
  const Visit visit(mutex_, waiting_);
  response.time_step = static_cast<double>(simulator_.stepNanoseconds()) * 1e-9;
  response.pause = !running_;
  response.max_update_rate = options_.real_time_factor / response.time_step;
  response.gravity.z = -config_.options.gravity;
  response.success = true;
  response.status_message = "GetPhysicsProperties: got properties";
  return true;
}

}  // namespace quad_sim
