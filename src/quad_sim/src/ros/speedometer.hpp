/// How fast the world runs, told on /gazebo/performance_metrics.
#pragma once

#include <ros/ros.h>

#include <chrono>
#include <cstdint>

namespace quad_sim {

/// Publishes simulated over wall time, at most five times a second as Gazebo does, while somebody
/// listens.
class Speedometer {
 public:
  explicit Speedometer(ros::NodeHandle& handle);
  void publish(
      std::int64_t time_ns);  ///< to be called whenever the world publishes; simulated time

 private:
  using Clock = std::chrono::steady_clock;
  ros::Publisher publisher_;
  Clock::time_point wall_ = Clock::now();  ///< of the latest message
  std::int64_t time_ns_ = 0;
};

}  // namespace quad_sim
