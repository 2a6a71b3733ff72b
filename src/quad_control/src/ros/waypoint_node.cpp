// Node waypoint_node: flies a file of waypoints and says how near it came to each. Parameters:
// ~file (a waypoint a line: seconds after the one before, x y z [m], yaw [degrees]), ~last (seconds
// given to the last), ~within [m].
#include <fmt/format.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/UInt32.h>
#include <std_srvs/Empty.h>

#include <cmath>
#include <stdexcept>

#include "conversions.hpp"
#include "quad_sim_ros/persistent_call.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"
#include "quad_support/program.hpp"

namespace quad_control {
namespace {

class WaypointNode {
 public:
  WaypointNode(std::vector<Waypoint> waypoints, double last, double within)
      : waypoints_(std::move(waypoints)), last_ns_(std::llround(last * 1e9)), within_(within) {
    trajectory_pub_ = handle_.advertise<trajectory_msgs::MultiDOFJointTrajectory>(
        "command/trajectory", 1, /*latch=*/true);
    reached_pub_ = handle_.advertise<std_msgs::UInt32>("waypoints_reached", 1, /*latch=*/true);
    odometry_sub_ = handle_.subscribe("odometry", 100, &WaypointNode::onOdometry, this);
  }

  /// @returns the exit code: 0 if every waypoint was reached, else 4
  int fly() {
    while (trajectory_pub_.getNumSubscribers() == 0 || odometry_sub_.getNumPublishers() == 0)
      wait();
    trajectory_pub_.publish(toMsg(waypoints_));
    std_srvs::Empty unpause;
    while (!quad_sim::persistentCall("/gazebo/unpause_physics", unpause)) wait();
    while (next_ < waypoints_.size()) wait();
    fmt::print("{} of {} waypoints reached within {} m\n", reached_, waypoints_.size(), within_);
    std::fflush(stdout);
    return reached_ == waypoints_.size() ? quad_support::kDone : quad_support::kSimulationFailed;
  }

 private:
  static void wait() {
    if (!ros::ok()) throw quad_support::EnvironmentError("ROS has shut down");
    quad_support::throwIfInterrupted();
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }

  void onOdometry(const nav_msgs::Odometry& message) {
    const quad_sim::Odometry now = quad_sim::fromMsg(message);
    if (start_ns_ < 0) start_ns_ = now.time_ns;
    while (next_ < waypoints_.size() && now.time_ns - start_ns_ >= endOf(next_)) judge(now);
  }

  /// When a waypoint should have been reached: when the next one begins.
  std::int64_t endOf(std::size_t i) const {
    return i + 1 < waypoints_.size() ? waypoints_[i + 1].from_start_ns
                                     : waypoints_[i].from_start_ns + last_ns_;
  }

  void judge(const quad_sim::Odometry& now) {
    const References& r = waypoints_[next_++].references;
    const double distance = (now.p_WB - Eigen::Vector3d(r.x, r.y, r.z)).norm();
    const double turn = wrapAngle(rollPitchYaw(now.q_WB).z() - r.yaw);
    constexpr double kTurn = 0.1;  // [rad]
    const bool reached = distance <= within_ && std::abs(turn) <= kTurn;
    reached_ += reached ? 1 : 0;
    fmt::print("waypoint {} ({}, {}, {}): {} at {:.2f} s, {:.3f} m and {:.3f} rad off\n", next_,
               r.x, r.y, r.z, reached ? "reached" : "MISSED",
               1e-9 * static_cast<double>(now.time_ns), distance, turn);
    std::fflush(stdout);
    std_msgs::UInt32 count;
    count.data = static_cast<std::uint32_t>(reached_);
    reached_pub_.publish(count);
  }

  std::vector<Waypoint> waypoints_;
  std::int64_t last_ns_, start_ns_ = -1;
  double within_;
  std::size_t next_ = 0, reached_ = 0;
  ros::NodeHandle handle_;
  ros::Publisher trajectory_pub_, reached_pub_;
  ros::Subscriber odometry_sub_;
};

double positive(const std::string& name, double fallback) {
  const double value = ros::param::param("~" + name, fallback);
  if (value > 0 && std::isfinite(value)) return value;
  throw quad_support::ConfigError(fmt::format("parameter ~{} = {}; must be > 0", name, value));
}

int run() {
  std::string path;
  if (!ros::param::get("~file", path))
    throw quad_support::ConfigError("parameter ~file is missing: a file of waypoints");
  WaypointNode node(readWaypoints(quad_support::readFile(path), path), positive("last", 25.0),
                    positive("within", 0.15));
  return node.fly();
}

}  // namespace
}  // namespace quad_control

int main(int argc, char** argv) {
  return quad_support::runProgram("waypoint_node", [&] {
    ros::init(argc, argv, "waypoints");
    const ros::NodeHandle keeps_ros_running;
    return quad_control::run();
  });
}
