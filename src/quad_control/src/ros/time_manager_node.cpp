// Node time_manager_node: moves simulated time by control intervals, thesis section 1.2.4.
// Parameters: ~config, ~mode.
#include <fmt/format.h>
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <thread>

#include "conversions.hpp"
#include "quad_control/Advance.h"
#include "quad_control/Begin.h"
#include "quad_control/TimingReport.h"
#include "quad_control/time_manager.hpp"
#include "quad_support/errors.hpp"
#include "simulator_client.hpp"
#include "spin.hpp"

namespace quad_control {
namespace {

using WallClock = std::chrono::steady_clock;

double since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

double positive(double timeout) {
  if (timeout > 0.0 && std::isfinite(timeout)) return timeout;
  throw quad_support::ConfigError(fmt::format("timeout = {} s; must be > 0 s", timeout));
}

class TimeManagerNode {
 public:
  TimeManagerNode(const TimingConfig& timing, double step)
      : timing_(timing), step_(step), private_handle_("~"), manager_(timing.forgetting_factor) {
    begin_srv_ = private_handle_.advertiseService("begin", &TimeManagerNode::begin, this);
    advance_srv_ = private_handle_.advertiseService("advance", &TimeManagerNode::advance, this);
    end_srv_ = private_handle_.advertiseService("end", &TimeManagerNode::end, this);
  }

 private:
  bool begin(Begin::Request& request, Begin::Response& response) {
    return answered(response, [&] {
      flying_ = false;
      manager_.reset();
      intervals_ = IntervalStatistics();
      delays_ = IntervalStatistics();
      simulator_.waitUntilThere(positive(request.timeout));
      simulator_.pause();
      simulator_.startAfresh();
      finish(simulator_.read(ros::Time(), request.timeout), response);
      flying_ = true;
    });
  }

  bool advance(Advance::Request& request, Advance::Response& response) {
    return answered(response, [&] {
      requireFlight();
      positive(request.timeout);
      const std::int64_t before = quad_sim::simulatedTime(command_stamp_);
      response.service_delay = timing_.mode == TimingMode::kLockstep
                                   ? stepOnce(request, before, response)
                                   : runForAWhile(request, before, response);
      response.estimated_service_delay = manager_.estimatedDelay();
      delays_.add(response.service_delay, 0.0);
      const std::int64_t after = quad_sim::simulatedTime(command_stamp_);
      intervals_.add(1e-9 * static_cast<double>(after - before), request.steps * step_);
    });
  }

  bool end(TimingReport::Request& request, TimingReport::Response& response) {
    return answered(response, [&] {
      requireFlight();
      simulator_.read(command_stamp_, positive(request.timeout));
      flying_ = false;
      response.mode = toString(timing_.mode);
      response.intervals = static_cast<std::uint32_t>(intervals_.count());
      response.desired = timing_.sampling_period;
      response.mean = intervals_.mean();
      response.std = intervals_.std();
      response.max_abs_error = intervals_.maxAbsError();
      response.mean_service_delay = delays_.mean();
      response.estimated_service_delay = manager_.estimatedDelay();
    });
  }

  // Lock-step: the simulator itself waits for the command. Returns the wall time it took [s].
  double stepOnce(const Advance::Request& request, std::int64_t before,
                  Advance::Response& response) {
    const WallClock::time_point start = WallClock::now();
    quad_sim::Step::Request step;
    step.steps = request.steps;
    step.hold_steps = request.hold_steps;
    step.command_stamp = command_stamp_;
    insist(request.timeout, [&](double timeout) {
      step.timeout = timeout;
      finish(simulator_.step(step, before), response);
    });
    return since(start);
  }

  // Thesis Fig. 1.5 and section 1.2.4, steps (e) to (j). Returns x^noise = dT_sim − dT_ctrl [s].
  double runForAWhile(const Advance::Request& request, std::int64_t before,
                      Advance::Response& response) {
    if (request.hold_steps != 0) {
      throw quad_support::ConfigError(
          fmt::format("hold_steps = {}; must be 0 in wall-clock mode, where the latency is the "
                      "middleware's own (timing.latency: 0)",
                      request.hold_steps));
    }
    insist(request.timeout, [&](double timeout) {
      simulator_.read(command_stamp_, timeout);  // the command is in, so unpausing flies with it
    });
    const double wait = manager_.waitFor(request.steps * step_);
    response.wait = wait;
    simulator_.unpause();
    std::this_thread::sleep_for(std::chrono::duration<double>(wait));
    simulator_.pause();
    finish(simulator_.read(ros::Time(), request.timeout), response);
    const double interval =
        1e-9 * static_cast<double>(quad_sim::simulatedTime(command_stamp_) - before);
    manager_.measured(wait, interval);
    return interval - wait;
  }

  // Calls ask(timeout [s]), which needs the controller's command. The first one of a flight may be
  // lost, for the nodes are still connecting then: nothing has been run, so the state is published
  // again and the same asked once more.
  template <class Ask>
  void insist(double timeout, const Ask& ask) {
    if (intervals_.count() > 0) return ask(timeout);
    constexpr double kPatience = 0.5, kPause = 0.02;  // [s]
    const WallClock::time_point start = WallClock::now();
    for (;;) {
      try {
        return ask(std::min(kPatience, timeout));
      } catch (const quad_support::EnvironmentError&) {
        if (since(start) >= timeout) throw;
      }
      std::this_thread::sleep_for(std::chrono::duration<double>(kPause));
      simulator_.read(ros::Time(), timeout);
    }
  }

  template <class Response>
  void finish(quad_sim::Step::Response&& now, Response& response) {
    command_stamp_ = now.odometry.header.stamp;
    response.stamp = now.odometry.header.stamp;
    response.message = std::move(now.message);
    response.odometry = std::move(now.odometry);
    response.motor_speed = std::move(now.motor_speed);
  }

  void requireFlight() const {
    if (!flying_)
      throw quad_support::ConfigError("no flight has begun; call the service begin first");
  }

  template <class Response, class Body>
  static bool answered(Response& response, const Body& body) {
    try {
      body();
      response.success = true;
    } catch (const std::exception& e) {
      response.success = false;
      response.message = e.what();
    }
    return true;
  }

  TimingConfig timing_;
  double step_;  // physics step [s]
  ros::NodeHandle private_handle_;
  SimulatorClient simulator_;
  TimeManager manager_;
  IntervalStatistics intervals_, delays_;
  ros::Time command_stamp_;  // of the odometry answered last, as it stands in its header
  bool flying_ = false;
  ros::ServiceServer begin_srv_, advance_srv_, end_srv_;
};

}  // namespace
}  // namespace quad_control

int main(int argc, char** argv) {
  return quad_support::runProgram("time_manager_node", [&] {
    ros::init(argc, argv, "time_manager");
    const ros::NodeHandle keeps_ros_running;
    quad_control::NodeConfig config = quad_control::readNodeConfig();
    const auto mode = ros::param::param<std::string>("~mode", "");  // in place of the file's
    config.timing.mode = quad_control::timingMode(mode, config.timing.mode);
    const quad_control::TimeManagerNode node(config.timing, config.step);
    return quad_control::spinUntilInterrupted();
  });
}
