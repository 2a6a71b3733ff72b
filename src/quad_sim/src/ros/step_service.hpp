/// /gazebo/step: lock-step, which Gazebo lacks.
#pragma once

#include <quad_sim/Step.h>
#include <ros/ros.h>

#include <optional>
#include <string>
#include <vector>

#include "sim_world.hpp"

namespace quad_sim {

/// Waits for the command of a stamp, then moves the world by exactly as many steps as were asked
/// for.
class StepService {
 public:
  StepService(SimWorld& world, ros::NodeHandle& handle);

 private:
  bool onStep(Step::Request& request, Step::Response& response);
  std::string run(const Step::Request& request);  ///< what went wrong; empty if nothing did
  /// A command to fly with, if there is one.
  struct Order {
    Vehicle* vehicle;
    std::optional<ArrivedCommand> command;
  };
  std::string collect(const Step::Request& request,
                      std::vector<Order>& orders);  ///< waits; what went wrong
  std::string groundMessage();

  SimWorld& world_;
  ros::ServiceServer server_;
};

}  // namespace quad_sim
