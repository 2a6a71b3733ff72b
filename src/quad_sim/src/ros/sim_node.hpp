/// The simulator as a ROS node that speaks like Gazebo with RotorS's plugins, plus /gazebo/step.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <vector>

#include "gazebo_services.hpp"
#include "link_services.hpp"
#include "model_services.hpp"
#include "property_services.hpp"
#include "sim_world.hpp"
#include "spawn_services.hpp"
#include "step_service.hpp"

namespace quad_sim {

/// The world and the services that act on it, on a thread of their own, so that a Step may wait for
/// a command.
class SimNode {
 public:
  SimNode(const std::vector<VehicleSpec>& fleet, const SimNodeOptions& options)
      : handle_(withQueue(queue_)),
        world_(fleet, options, handle_),
        step_(world_, handle_),
        gazebo_(world_, handle_),
        models_(world_, handle_),
        links_(world_, handle_),
        spawner_(world_, handle_),
        properties_(world_, handle_),
        spinner_(1, &queue_) {
    spinner_.start();
  }
  ~SimNode() {
    world_.stopWaiting();
    spinner_.stop();
  }

 private:
  static ros::NodeHandle withQueue(ros::CallbackQueue& queue) {
    ros::NodeHandle handle;
    handle.setCallbackQueue(&queue);
    return handle;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  SimWorld world_;
  StepService step_;
  GazeboServices gazebo_;
  ModelServices models_;
  LinkServices links_;
  SpawnServices spawner_;
  PropertyServices properties_;
  ros::AsyncSpinner spinner_;
};

}  // namespace quad_sim
