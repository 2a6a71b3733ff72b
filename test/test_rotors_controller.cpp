// A controller that knows only RotorS flies with our node: hover and a waypoint, paced in simulated
// time and in lock-step.
#include <gazebo_msgs/GetModelState.h>
#include <gtest/gtest.h>
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <quad_sim/Step.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "quad_sim_ros/persistent_call.hpp"

namespace {

using quad_sim::Step;
using WallClock = std::chrono::steady_clock;

/// RotorS's controllers assume 0.716 kg and 9.81 m/s² and know no integral: with 4 N/m they sag by
/// (0.716 * 9.81 - 0.73103 * 9.8) / 4.
constexpr double kSag = -0.0350;  // [m]

template <class Condition>
bool eventually(const Condition& condition, int seconds) {
  const auto limit = WallClock::now() + std::chrono::seconds(seconds);
  while (!condition() && ros::ok() && WallClock::now() < limit) {
    ros::spinOnce();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

double yawOf(const nav_msgs::Odometry& o) {
  const auto& q = o.pose.pose.orientation;
  return std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

class RotorsController : public testing::Test {
 protected:
  void SetUp() override {
    goal_ = n_.advertise<trajectory_msgs::MultiDOFJointTrajectory>(
        "/hummingbird/command/trajectory", 1);
    odometry_ = n_.subscribe("/hummingbird/odometry_sensor1/odometry", 100,
                             &RotorsController::onOdometry, this);
    motors_ =
        n_.subscribe("/hummingbird/command/motor_speed", 1, &RotorsController::onMotors, this);
    ASSERT_TRUE(ros::service::waitForService("/gazebo/step", ros::Duration(-1)));
    ASSERT_TRUE(eventually(
        [&] {
          return goal_.getNumSubscribers() > 0 && odometry_.getNumPublishers() > 0 &&
                 motors_.getNumPublishers() > 0;
        },
        20));
    call("/gazebo/pause_physics");
    call("/gazebo/reset_simulation");
    seen_.clear();
  }
  void onOdometry(const nav_msgs::Odometry& o) { seen_.push_back(o); }
  void onMotors(const mav_msgs::Actuators&) { ++commands_; }
  void call(const std::string& service) {
    std_srvs::Empty empty;
    ASSERT_TRUE(quad_sim::persistentCall(service, empty)) << service;
  }
  void goTo(double x, double y, double z, double yaw) {
    trajectory_msgs::MultiDOFJointTrajectory message;
    message.points.resize(1);
    message.points[0].transforms.resize(1);
    auto& t = message.points[0].transforms[0];
    t.translation.x = x;
    t.translation.y = y;
    t.translation.z = z;
    t.rotation.w = std::cos(yaw / 2);
    t.rotation.z = std::sin(yaw / 2);
    goal_.publish(message);
  }
  bool isAt(double x, double y, double z, double yaw, double within) const {
    if (seen_.empty()) return false;
    const auto& p = seen_.back().pose.pose.position;
    const auto& v = seen_.back().twist.twist.linear;
    return std::hypot(p.x - x, p.y - y, p.z - z) < within &&
           std::abs(std::remainder(yawOf(seen_.back()) - yaw, 2 * M_PI)) < within &&
           std::hypot(v.x, v.y, v.z) < within;
  }
  /// Lock-step: 10 ms an interval, each after the command that answers the last odometry.
  Step::Response lockstep(double seconds) {
    static ros::ServiceClient client = n_.serviceClient<Step>("/gazebo/step", true);
    Step s;
    s.request.timeout = 30;
    for (int k = 0; k < std::lround(seconds / 0.01); ++k) {
      s.request.steps = 10;
      s.request.command_stamp = stamp_;
      if (!client.call(s) || !s.response.success) {
        ADD_FAILURE() << s.response.message;
        break;
      }
      stamp_ = s.response.odometry.header.stamp;
    }
    return s.response;
  }

  ros::NodeHandle n_;
  ros::Publisher goal_;
  ros::Subscriber odometry_, motors_;
  std::vector<nav_msgs::Odometry> seen_;
  int commands_ = 0;
  ros::Time stamp_;
};

TEST_F(RotorsController, FliesHoverAndWaypointPacedInSimulatedTime) {
  call("/gazebo/unpause_physics");
  goTo(0, 0, 1, 0);
  EXPECT_TRUE(eventually([&] { return isAt(0, 0, 1 + kSag, 0, 0.03); }, 40)) << "does not hover";
  goTo(1, 0.5, 1.5, M_PI_2);
  EXPECT_TRUE(eventually([&] { return isAt(1, 0.5, 1.5 + kSag, M_PI_2, 0.03); }, 60))
      << "does not reach the waypoint";
  call("/gazebo/pause_physics");
  // The contract of the topic: body-frame twist in the sensor's frame, one message every 10 ms of
  // simulated time.
  ASSERT_GT(seen_.size(), 100U);
  EXPECT_EQ(seen_.back().header.frame_id, "world");
  EXPECT_EQ(seen_.back().child_frame_id, "hummingbird/odometry_sensor1");
  int regular = 0;
  for (std::size_t i = 2; i + 1 < seen_.size(); ++i) {
    regular += (seen_[i].header.stamp - seen_[i - 1].header.stamp).toNSec() == 10000000 ? 1 : 0;
  }
  EXPECT_GT(regular, 0.9 * static_cast<double>(seen_.size()))
      << "a busy listener may lose some, no more";
}

TEST_F(RotorsController, FliesTheSameInLockstep) {
  goTo(0, 0, 1, 0);
  Step first;  // until the controller, too, has heard: its answer to the first odometry is no
               // longer zero
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/step", first));
  stamp_ = first.response.odometry.header.stamp;
  Step::Response now = lockstep(25);
  EXPECT_NEAR(now.odometry.pose.pose.position.z, 1 + kSag, 0.001);
  for (const double w : now.motor_speed.angular_velocities) EXPECT_NEAR(std::abs(w), 457.72, 0.05);
  goTo(1, 0.5, 1.5, M_PI_2);
  now = lockstep(25);
  EXPECT_NEAR(now.odometry.pose.pose.position.x, 1, 0.001);
  EXPECT_NEAR(now.odometry.pose.pose.position.y, 0.5, 0.001);
  EXPECT_NEAR(now.odometry.pose.pose.position.z, 1.5 + kSag, 0.001);
  EXPECT_NEAR(yawOf(now.odometry), M_PI_2, 0.001);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_rotors_controller");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
