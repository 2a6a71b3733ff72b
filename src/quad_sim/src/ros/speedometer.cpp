#include "speedometer.hpp"

#include <gazebo_msgs/PerformanceMetrics.h>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

Speedometer::Speedometer(ros::NodeHandle& handle)
    : publisher_(
          handle.advertise<gazebo_msgs::PerformanceMetrics>("/gazebo/performance_metrics", 10)) {}

void Speedometer::publish(std::int64_t time_ns) {
  constexpr double kInterval = 0.2;  // [s] of wall time
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - wall_).count();
  if (elapsed < kInterval) return;
  gazebo_msgs::PerformanceMetrics message;
  message.header.stamp = toStamp(time_ns);
  message.real_time_factor =
      time_ns > time_ns_ ? 1e-9 * static_cast<double>(time_ns - time_ns_) / elapsed : 0.0;
  wall_ = now;
  time_ns_ = time_ns;
  if (publisher_.getNumSubscribers() > 0) publisher_.publish(message);
}

}  // namespace quad_sim
