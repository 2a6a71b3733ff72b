// The simulator node. Parameters: ~config, ~publish_every, ~paused, ~vehicles, ~real_time_factor,
// ~seed; see launch/sim.launch.
#include <ros/ros.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "fleet.hpp"
#include "quad_support/interrupt.hpp"
#include "quad_support/program.hpp"
#include "sim_node.hpp"

namespace {

quad_sim::SimNodeOptions readOptions(const ros::NodeHandle& own, double step) {
  quad_sim::SimNodeOptions options;
  const int ten_milliseconds = static_cast<int>(std::max(1.0, std::round(0.01 / step)));
  options.publish_every = own.param("publish_every", ten_milliseconds);
  options.real_time_factor = own.param("real_time_factor", 1.0);
  options.paused = own.param("paused", true);
  if (options.publish_every < 0)
    throw std::invalid_argument("~publish_every must be >= 0 physics steps");
  if (!(options.real_time_factor >= 0) || !std::isfinite(options.real_time_factor)) {
    throw std::invalid_argument("~real_time_factor must be >= 0 (0: as fast as possible)");
  }
  return options;
}

int run(int argc, char** argv) {
  ros::init(argc, argv, "gazebo");
  const ros::NodeHandle own("~");
  std::string path;
  if (!own.getParam("config", path) || path.empty()) {
    throw std::invalid_argument(
        "parameter ~config is missing; give the path of a YAML file, for instance "
        "roslaunch launch/sim.launch config:=config/thesis.yaml");
  }
  const std::vector<quad_sim::VehicleSpec> fleet = quad_sim::readFleet(own, path);
  const quad_sim::SimNode node(fleet, readOptions(own, fleet.front().options.step));
  while (ros::ok()) {
    quad_support::throwIfInterrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return quad_support::runProgram("quad_sim_node", [&] { return run(argc, argv); });
}
