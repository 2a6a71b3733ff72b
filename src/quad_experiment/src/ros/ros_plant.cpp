#include "ros_plant.hpp"

#include <fmt/core.h>
#include <quad_control/Advance.h>
#include <quad_control/Begin.h>
#include <quad_control/FlightRecord.h>
#include <quad_control/SetFlightPlan.h>
#include <quad_control/TimingReport.h>

#include <cmath>
#include <thread>

#include "quad_sim_ros/conversions.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"

namespace quad_experiment {
namespace {

using quad_support::EnvironmentError;

quad_sim::Measurement toMeasurement(const nav_msgs::Odometry& odometry,
                                    const mav_msgs::Actuators& motor_speed,
                                    const std::string& message) {
  quad_sim::Measurement m;
  m.odometry = quad_sim::fromMsg(odometry);
  for (const double speed : motor_speed.angular_velocities)
    m.rotor_speed.push_back(std::abs(speed));
  m.ground_contact_ns = quad_sim::groundContactTime(message);
  return m;
}

template <class Service>
ros::ServiceClient connect(ros::NodeHandle& node, const std::string& name,
                           std::chrono::steady_clock::time_point deadline) {
  while (!ros::service::exists(name, false)) {
    quad_support::throwIfInterrupted();
    if (!ros::ok()) throw EnvironmentError("ROS was shut down before the flight");
    if (std::chrono::steady_clock::now() > deadline) {
      throw EnvironmentError(
          fmt::format("nobody offers the service {}; is its node running?", name));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return node.serviceClient<Service>(name, true);
}

}  // namespace

template <class Service>
void RosPlant::ask(ros::ServiceClient& client, Service& service) {
  // The one who is asked waits at most `timeout` for others; what it needs itself comes on top.
  constexpr double kOwnWork = 1.5;  // [s] of wall time: an interval's physics and a busy machine
  const double limit = options_.timeout + kOwnWork;
  bool late = false;
  if (!answers_.call(client, service, limit, late)) {
    quad_support::throwIfInterrupted();
    throw EnvironmentError(
        late ? fmt::format("{} did not answer within {} s: its node, or one it waits for, hangs",
                           client.getService(), limit)
             : fmt::format("{} does not answer: its node was lost", client.getService()));
  }
  if (service.response.success) return;
  quad_support::throwIfInterrupted();
  const std::string text = fmt::format("{}: {}", client.getService(), service.response.message);
  if (text.find("simulation failed: ") != std::string::npos)
    throw quad_support::SimulationError(text);
  throw EnvironmentError(text);
}

RosPlant::RosPlant(ros::NodeHandle& node, const RosPlantOptions& options, double start_timeout)
    : options_(options) {
  const auto deadline = std::chrono::steady_clock::now() +
                        std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                            std::chrono::duration<double>(start_timeout));
  set_flight_plan_ =
      connect<quad_control::SetFlightPlan>(node, options.controller + "/set_flight_plan", deadline);
  flight_record_ =
      connect<quad_control::FlightRecord>(node, options.controller + "/flight_record", deadline);
  begin_ = connect<quad_control::Begin>(node, options.time_manager + "/begin", deadline);
  advance_ = connect<quad_control::Advance>(node, options.time_manager + "/advance", deadline);
  end_ = connect<quad_control::TimingReport>(node, options.time_manager + "/end", deadline);
}

quad_sim::Measurement RosPlant::begin(const quad_control::FlightPlan& plan) {
  quad_control::SetFlightPlan set;
  set.request.x = plan.references.x;
  set.request.y = plan.references.y;
  set.request.z = plan.references.z;
  set.request.yaw = plan.references.yaw;
  set.request.feed_forward_mass = plan.feed_forward_mass;
  set.request.initial_altitude_effort = plan.initial_altitude_effort;
  set.request.exploration_signal = plan.exploration_signal;
  if (!plan.exploration_signal.empty()) {
    set.request.exploration_start.fromNSec(static_cast<std::uint64_t>(plan.exploration_start_ns));
  }
  ask(set_flight_plan_, set);
  quad_control::Begin begin;
  begin.request.timeout = options_.timeout;
  ask(begin_, begin);
  started_ = std::chrono::steady_clock::now();
  timing_.clear();
  return toMeasurement(begin.response.odometry, begin.response.motor_speed, begin.response.message);
}

quad_sim::Measurement RosPlant::advance(const Interval& interval) {
  quad_control::Advance call;
  call.request.steps = static_cast<std::uint32_t>(interval.steps);
  call.request.hold_steps = static_cast<std::uint32_t>(interval.hold_steps);
  call.request.timeout = options_.timeout;
  ask(advance_, call);
  if (options_.mode == "wallclock") {
    timing_.push_back(
        {call.response.wait, call.response.service_delay, call.response.estimated_service_delay});
  }
  pace(quad_sim::simulatedTime(call.response.odometry.header.stamp));
  return toMeasurement(call.response.odometry, call.response.motor_speed, call.response.message);
}

std::vector<quad_control::ControlOutput> RosPlant::end() {
  quad_control::TimingReport report;
  report.request.timeout = options_.timeout;
  ask(end_, report);
  if (report.response.mode != options_.mode) {
    throw quad_support::ConfigError(
        fmt::format("{} works in mode {}, the experiment in {}; set the same ~mode for both",
                    options_.time_manager, report.response.mode, options_.mode));
  }
  quad_control::FlightRecord record;
  ask(flight_record_, record);
  const auto& r = record.response;
  std::vector<quad_control::ControlOutput> commands(r.time.size());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    commands[i].time_ns = quad_sim::simulatedTime(r.time[i]);
    commands[i].thrust = r.thrust.at(i);
    commands[i].tau_phi = r.tau_phi.at(i);
    commands[i].tau_theta = r.tau_theta.at(i);
    commands[i].tau_psi = r.tau_psi.at(i);
    commands[i].t_eff = r.t_eff.at(i);
    commands[i].clamped = static_cast<int>(r.clamped.at(i));
  }
  return commands;
}

void RosPlant::pace(std::int64_t time_ns) {
  if (options_.rate <= 0.0) return;
  std::this_thread::sleep_until(started_ + std::chrono::nanoseconds(std::llround(
                                               static_cast<double>(time_ns) / options_.rate)));
}

}  // namespace quad_experiment
