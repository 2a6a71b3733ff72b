#include "simulator_client.hpp"

#include <fmt/format.h>
#include <quad_sim/RestoreState.h>
#include <quad_sim/SaveState.h>

#include <utility>

#include "conversions.hpp"
#include "quad_sim_ros/persistent_call.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

using quad_sim::persistentCall;
using quad_support::EnvironmentError;

constexpr char kStep[] = "/gazebo/step";

[[noreturn]] void failUnreachable(const std::string& service) {
  throw EnvironmentError(
      service + " does not answer: the simulator is gone or was never started (quad_sim_node)");
}

// Once more on a new connection; only for what is the same twice as once.
template <class Service>
void insist(ros::ServiceClient& client, const std::string& name, Service& call) {
  if (!persistentCall(client, name, call) && !persistentCall(client, name, call))
    failUnreachable(name);
}

}  // namespace

void SimulatorClient::waitUntilThere(double timeout) {
  // Not ros::service::waitForService: it counts simulated time, which stands still while the
  // simulator is missing.
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(timeout);
  while (!ros::service::exists(kStep, /*print_failure_reason=*/false)) {
    if (ros::WallTime::now() >= end || !ros::ok()) failUnreachable(kStep);
    ros::WallDuration(0.02).sleep();
  }
}

void SimulatorClient::callEmpty(ros::ServiceClient& client, const std::string& name) {
  std_srvs::Empty call;
  insist(client, name, call);
}

bool SimulatorClient::restoreStart() {
  if (start_.empty()) return false;
  quad_sim::RestoreState call;
  call.request.state = start_;
  insist(restore_, "/gazebo/restore_state", call);
  return call.response.success;  // refused: somebody has changed the physics or the vehicles
}

void SimulatorClient::startAfresh() {
  callEmpty(reset_, "/gazebo/reset_simulation");
  if (restoreStart()) return;
  quad_sim::SaveState call;
  insist(save_, "/gazebo/save_state", call);
  start_ = call.response.state;
}

bool SimulatorClient::tryStep(quad_sim::Step& call) {
  if (!persistentCall(step_, kStep, call)) return false;
  if (!call.response.success)
    throw EnvironmentError(std::string(kStep) + ": " + call.response.message);
  return true;
}

quad_sim::Step::Response SimulatorClient::read(const ros::Time& command_stamp, double timeout) {
  quad_sim::Step call;
  call.request.command_stamp = command_stamp;
  call.request.timeout = timeout;
  if (!tryStep(call) && !tryStep(call)) failUnreachable(kStep);  // reading changes nothing
  return std::move(call.response);
}

quad_sim::Step::Response SimulatorClient::step(const quad_sim::Step::Request& request,
                                               std::int64_t before_ns) {
  quad_sim::Step call;
  call.request = request;
  if (tryStep(call)) return std::move(call.response);
  quad_sim::Step::Response now = read(ros::Time(), request.timeout);
  if (quad_sim::simulatedTime(now.odometry.header.stamp) != before_ns)
    return now;  // made; only the answer was lost
  if (!tryStep(call)) failUnreachable(kStep);
  return std::move(call.response);
}

}  // namespace quad_control
