#include "step_service.hpp"

#include <fmt/core.h>

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
  const auto contact = world_.simulator().groundContactTime();
  if (!contact) return "";
  return "ground contact at " + quad_support::shortest(static_cast<double>(*contact) * 1e-9) + " s";
}

std::string StepService::run(const Step::Request& request) {
  const std::string problem = impossible(request);
  if (!problem.empty()) return problem;
  constexpr double kDefaultTimeout = 10.0;  // [s]
  const double timeout = request.timeout > 0 ? request.timeout : kDefaultTimeout;
  const std::int64_t stamp = toNanoseconds(request.command_stamp);
  const auto command =
      stamp == 0 ? world_.inbox().latest() : world_.inbox().waitFor(stamp, timeout);
  if (stamp != 0 && !command) {
    return fmt::format("no command stamped {}.{:09} s on /{}/command/motor_speed within {} s",
                       request.command_stamp.sec, request.command_stamp.nsec, world_.vehicleName(),
                       quad_support::shortest(timeout));
  }
  const bool usable = command && command->problem.empty();
  if (stamp != 0 && !usable) return "the command was refused: " + command->problem;
  const WorldGate::Visit visit(world_.gate());
  if (world_.running()) return kRunning;
  Simulator& simulator = world_.simulator();
  simulator.advance(static_cast<int>(request.hold_steps));
  if (usable && request.steps > 0) simulator.setCommand(command->rotor_speed);
  simulator.advance(static_cast<int>(request.steps - request.hold_steps));
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
  response.stamp = toTime(world_.simulator().timeNanoseconds());
  response.odometry = world_.topics().odometry();
  response.motor_speed = world_.topics().motorSpeed();
  return true;
}

}  // namespace quad_sim
