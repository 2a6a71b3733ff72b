// Control steps a second over ROS, in lock-step with separate nodes. Start launch/sim.launch with a high
// initial_altitude, then `lockstep_rate controller &` and `lockstep_rate steps`. The controller answers each odometry with
// a constant command; the other advances by 100 physics steps an interval.
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <quad_sim/Step.h>
#include <ros/ros.h>

#include <chrono>
#include <cstdio>
#include <cstring>

namespace {

int control(ros::NodeHandle& n) {
  const ros::Publisher publisher = n.advertise<mav_msgs::Actuators>("/hummingbird/command/motor_speed", 10);
  mav_msgs::Actuators command;
  command.angular_velocities.assign(4, 457.0);
  const boost::function<void(const nav_msgs::Odometry&)> answer = [&](const nav_msgs::Odometry& odometry) {
    command.header.stamp = odometry.header.stamp;
    publisher.publish(command);
  };
  const ros::Subscriber subscriber = n.subscribe<nav_msgs::Odometry>(
      "/hummingbird/odometry_sensor1/odometry", 10, answer, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::spin();
  return 0;
}

int step(ros::NodeHandle& n) {
  constexpr int kWarmUp = 200, kIntervals = 10000;
  ros::service::waitForService("/gazebo/step");
  ros::ServiceClient client = n.serviceClient<quad_sim::Step>("/gazebo/step", true);
  quad_sim::Step call;
  call.request.timeout = 5;
  auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < kWarmUp + kIntervals; ++k) {
    if (k == kWarmUp) start = std::chrono::steady_clock::now();
    if (!client.call(call) || !call.response.success) {
      std::fprintf(stderr, "lockstep_rate: step %d failed: %s\n", k, call.response.message.c_str());
      return 5;
    }
    call.request.steps = 100;
    call.request.command_stamp = call.response.odometry.header.stamp;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%.0f control steps/s (%.1f us each)\n", kIntervals / seconds, seconds / kIntervals * 1e6);
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
