#include "step_service.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "quad_sim_ros/conversions.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

const char kRunning[] = "the physics is running; call /gazebo/pause_physics first";

std::string impossible(const Step::Request& request) {
  constexpr std::uint32_t kMaxSteps =
      1000000000;  // keeps a negative number sent as unsigned from running for days
  if (request.steps > kMaxSteps)
    return fmt::format("steps = {}; must be <= {}", request.steps, kMaxSteps);
  if (request.hold_steps > request.steps) {
    return fmt::format("hold_steps = {}; must be <= steps = {}", request.hold_steps, request.steps);
  }
  if (!(request.timeout >= 0 && request.timeout <= CommandInbox::kLongestWait)) {
    return fmt::format("timeout = {} s; must lie in [0, {}] s",
                       quad_support::shortest(request.timeout), CommandInbox::kLongestWait);
  }
  return "";
}

}  // namespace

StepService::StepService(SimWorld& world, ros::NodeHandle& handle)
    : world_(world), server_(handle.advertiseService("/gazebo/step", &StepService::onStep, this)) {}

std::string StepService::groundMessage() {
  std::string text;
  for (const auto& vehicle : world_.vehicles()) {
    const auto contact = vehicle->simulator.groundContactTime();
    if (!contact) continue;
    if (!text.empty()) text += "; ";
    if (world_.vehicles().size() > 1) text += vehicle->name + ": ";
    text += groundContactMessage(contact);
  }
  return text;
}

std::string StepService::collect(const Step::Request& request, std::vector<Order>& orders) {
  constexpr double kDefaultTimeout = 10.0;  // [s]
  const double timeout = request.timeout > 0 ? request.timeout : kDefaultTimeout;
  const std::int64_t stamp = toNanoseconds(request.command_stamp);
  for (const std::string& name : request.wait_for) {
    if (!world_.find(name)) return fmt::format("wait_for: no vehicle '{}'", name);
  }
  for (const auto& vehicle : world_.vehicles()) {
    const bool awaited =
        std::any_of(request.wait_for.begin(), request.wait_for.end(),
                    [&](const std::string& name) { return world_.find(name) == vehicle.get(); });
    CommandInbox& inbox = vehicle->commands.inbox();
    if (stamp == 0 || (!awaited && !request.wait_for.empty())) {
      orders.push_back({vehicle.get(), inbox.latest()});
      continue;
    }
    orders.push_back({vehicle.get(), inbox.waitFor(stamp, timeout)});
    if (!orders.back().command) {
      return fmt::format("no command stamped {}.{:09} s on /{}/command/motor_speed within {} s",
                         request.command_stamp.sec, request.command_stamp.nsec, vehicle->name,
                         quad_support::shortest(timeout));
    }
    const std::string& problem = orders.back().command->problem;
    if (!problem.empty()) return "the command was refused: " + problem;
  }
  return "";
}

std::string StepService::run(const Step::Request& request) {
  std::string problem = impossible(request);
  std::vector<Order> orders;
  if (problem.empty()) problem = collect(request, orders);
  if (!problem.empty()) return problem;
  const WorldGate::Visit visit(world_.gate());
  if (world_.running()) return kRunning;
  world_.advance(request.hold_steps);
  for (const Order& order : orders) {
    if (order.command && request.steps > 0)
      order.vehicle->simulator.setCommand(order.command->rotor_speed);
  }
  world_.advance(request.steps - request.hold_steps);
  world_.publish();
  return "";
}

bool StepService::onStep(Step::Request& request, Step::Response& response) {
  try {
    // Asked before waiting for a command, for it may never come while running.
    response.message = world_.running() ? kRunning : run(request);
    response.success = response.message.empty();
  } catch (const quad_support::SimulationError& e) {
    response.message = std::string("simulation failed: ") + e.what();
  }
  const WorldGate::Visit visit(world_.gate());
  if (response.success) response.message = groundMessage();
  response.stamp = toTime(world_.timeNanoseconds());
  response.odometry = world_.first().topics.odometry();
  response.motor_speed = world_.first().topics.motorSpeed();
  return true;
}

}  // namespace quad_sim
