// Control steps a second over ROS, in lock-step with separate nodes. Start launch/sim.launch with a
// high initial_altitude, then `lockstep_rate controller &` and `lockstep_rate steps`. The
// controller answers each odometry with a constant command; the other advances by 100 physics steps
// an interval.
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <quad_sim/Step.h>
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

int control(ros::NodeHandle& n) {
  const ros::Publisher publisher =
      n.advertise<mav_msgs::Actuators>("/hummingbird/command/motor_speed", 10);
  mav_msgs::Actuators command;
  command.angular_velocities.assign(
      4, 458.0);  // [rad/s] climbs: near the ground, contacts would be timed
  const boost::function<void(const nav_msgs::Odometry&)> answer =
      [&](const nav_msgs::Odometry& odometry) {
        command.header.stamp = odometry.header.stamp;
        publisher.publish(command);
      };
  const ros::Subscriber subscriber =
      n.subscribe<nav_msgs::Odometry>("/hummingbird/odometry_sensor1/odometry", 10, answer,
                                      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::spin();
  return 0;
}

int step(ros::NodeHandle& n) {
  constexpr int kWarmUp = 200, kIntervals = 10000;
  ros::service::waitForService("/gazebo/step");
  ros::ServiceClient client = n.serviceClient<quad_sim::Step>("/gazebo/step", true);
  quad_sim::Step call;
  call.request.timeout = 5;
  std::vector<double> each;  // [s]
  each.reserve(kIntervals);
  auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < kWarmUp + kIntervals; ++k) {
    if (k == kWarmUp) start = std::chrono::steady_clock::now();
    const auto before = std::chrono::steady_clock::now();
    if (!client.call(call) || !call.response.success) {
      std::fprintf(stderr, "lockstep_rate: step %d failed: %s\n", k, call.response.message.c_str());
      return 5;
    }
    if (k >= kWarmUp)
      each.push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    call.request.steps = 100;
    call.request.command_stamp = call.response.odometry.header.stamp;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::sort(each.begin(), each.end());
  const auto quantile = [&](double q) {
    return each[static_cast<std::size_t>(q * (kIntervals - 1))] * 1e6;
  };
  std::printf(
      "%.0f control steps/s (mean %.1f us; least %.1f, median %.1f, 90 %% %.1f, 99 %% %.1f us)\n",
      kIntervals / seconds, seconds / kIntervals * 1e6, quantile(0), quantile(0.5), quantile(0.9),
      quantile(0.99));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "lockstep_rate", ros::init_options::AnonymousName);
  ros::NodeHandle n;
  if (argc == 2 && std::strcmp(argv[1], "controller") == 0) return control(n);
  if (argc == 2 && std::strcmp(argv[1], "steps") == 0) return step(n);
  std::fprintf(stderr, "usage: lockstep_rate controller|steps\n");
  return 2;
}
