// Node quad_experiment_node: flies the experiment with the nodes around it and writes its results.
// Parameters: ~config, ~out, ~force, ~mode, ~rate, ~status, ~time_manager, ~controller,
// ~start_timeout.
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "quad_experiment/experiment.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"
#include "ros_graph.hpp"
#include "ros_plant.hpp"

namespace quad_experiment {
namespace {

struct NodeOptions {
  std::string config, out, mode, status;
  bool force = false;
  double start_timeout = 30.0;  // [s] wall time for the other nodes to come up
  RosPlantOptions plant;
};

NodeOptions readOptions() {
  const ros::NodeHandle node("~");
  NodeOptions o;
  node.param<std::string>("config", o.config, "");
  node.param<std::string>("out", o.out, "");
  node.param<std::string>("mode", o.mode, "");
  node.param<std::string>("status", o.status, "");
  node.param<std::string>("time_manager", o.plant.time_manager, "/time_manager");
  node.param<std::string>("controller", o.plant.controller, "");
  node.param("force", o.force, false);
  node.param("rate", o.plant.rate, 0.0);
  node.param("command_timeout", o.plant.timeout, 3.0);
  node.param("start_timeout", o.start_timeout, 30.0);
  if (!(o.plant.timeout > 0.0 && std::isfinite(o.plant.timeout)))
    throw quad_support::ConfigError("~command_timeout must be > 0 s");
  if (o.config.empty() || o.out.empty()) {
    throw quad_support::ConfigError(
        "the parameters ~config and ~out must be set; launch/experiment.launch does so");
  }
  return o;
}

/// Publishes what is going on, at most ten times a second.
class StatusTopic {
 public:
  explicit StatusTopic(ros::NodeHandle& node)
      : publisher_(node.advertise<std_msgs::String>("/experiment/status", 1, true)) {}
  void operator()(const ExperimentStatus& s) {
    const auto now = std::chrono::steady_clock::now();
    if (s.flight == last_flight_ && s.phase == last_phase_ &&
        now - last_ < std::chrono::milliseconds(100))
      return;
    last_ = now;
    last_flight_ = s.flight;
    last_phase_ = s.phase;
    std_msgs::String message;
    message.data =
        nlohmann::ordered_json{{"flight", s.flight},     {"phase", s.phase}, {"time", s.time},
                               {"duration", s.duration}, {"z", s.z},         {"zdot", s.zdot}}
            .dump();
    publisher_.publish(message);
  }

 private:
  ros::Publisher publisher_;
  std::chrono::steady_clock::time_point last_;
  std::string last_flight_, last_phase_;
};

/// @param written  set to the results directory once it is there
/// @param problem  set to which promise was broken, if one was
int fly(ros::NodeHandle& node, const NodeOptions& options, std::string& written,
        std::string& problem) {
  const ExperimentConfig config = readExperimentConfig(options.config, options.mode);
  quad_support::ResultDirectory results(options.out, options.force);
  RosPlantOptions plant_options = options.plant;
  if (plant_options.controller.empty()) {
    plant_options.controller =
        "/" + config.simulation.vehicle_namespace + "/attitude_altitude_controller";
  }
  plant_options.mode = quad_control::toString(config.timing.mode);
  RosPlant plant(node, plant_options, options.start_timeout);
  StatusTopic topic(node);
  nlohmann::ordered_json graph;  // of the nodes in flight, asked once
  const ExperimentResult result =
      runExperiment(config, {&plant}, plant_options.mode, results, [&](const ExperimentStatus& s) {
        if (s.phase == "hold" && graph.is_null()) graph = rosGraph();
        topic(s);
      });
  if (!graph.is_null()) results.write("graph.json", graph.dump(2) + "\n");
  results.commit();
  written = results.path();
  problem = result.problem();
  std::printf("results: %s\n", written.c_str());
  return result.exitCode();
}

/// Flies, and leaves exit code, reason and the results' place (if there are any) in the status
/// file, since roslaunch passes on none of them.
int flyAndReport(int argc, char** argv) {
  ros::init(argc, argv, "experiment", ros::init_options::NoSigintHandler);
  ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  std::string status;
  ros::param::get("~status", status);
  std::string message, written;
  const int code = quad_support::runProgram(
      "experiment", [&] { return fly(node, readOptions(), written, message); }, &message);
  if (!status.empty()) {
    const nlohmann::ordered_json answer = {
        {"exit_code", code}, {"message", message}, {"results", written}};
    quad_support::writeFileAtomically(status, answer.dump() + "\n");
  }
  return code;
}

}  // namespace
}  // namespace quad_experiment

int main(int argc, char** argv) {
  return quad_support::runProgram("experiment",
                                  [&] { return quad_experiment::flyAndReport(argc, argv); });
}
