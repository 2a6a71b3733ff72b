/// The loop of a node.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "quad_support/interrupt.hpp"
#include "quad_support/program.hpp"

namespace quad_control {

/// Runs callbacks on this thread until ROS shuts down; what they throw comes out. SIGTERM ends it
/// like SIGINT.
inline int spinUntilInterrupted() {
  const ros::WallDuration nap(
      0.1);  // how long a signal may wait; a callback wakes the loop at once
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(nap);
    quad_support::throwIfInterrupted();
  }
  return 0;
}

}  // namespace quad_control
