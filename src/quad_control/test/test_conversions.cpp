#include <gtest/gtest.h>

#include <limits>

#include "../src/ros/conversions.hpp"

namespace quad_control {
namespace {

TEST(Messages, PlanWithoutSignalHoldsForEver) {
  SetFlightPlan::Request request;
  request.z = 7.0;
  request.feed_forward_mass = 0.6;
  request.exploration_start = ros::Time(6, 0);
  EXPECT_EQ(fromMsg(request, 9.8).exploration_start_ns, std::numeric_limits<std::int64_t>::max());
  request.exploration_signal = {1.0, 2.0};
  const FlightPlan plan = fromMsg(request, 9.8);
  EXPECT_EQ(plan.exploration_start_ns, 6'000'000'000);
  EXPECT_EQ(plan.exploration_signal, request.exploration_signal);
  EXPECT_EQ(plan.references.z, 7.0);
  EXPECT_EQ(plan.gravity, 9.8);
}

TEST(Messages, RecordKeepsOrderAndFigures) {
  std::vector<ControlOutput> record(2);
  record[0].thrust = 7.0;
  record[1].time_ns = 100'000'000;
  record[1].tau_psi = -0.01;
  record[1].clamped = 2;
  FlightRecord::Response response;
  toMsg(record, response);
  ASSERT_EQ(response.time.size(), 2u);
  EXPECT_EQ(response.time[0], ros::Time(0, 1));
  EXPECT_EQ(response.thrust[0], 7.0);
  EXPECT_EQ(response.tau_psi[1], -0.01);
  EXPECT_EQ(response.clamped[1], 2u);
}

TEST(Messages, WrenchAndPose) {
  const geometry_msgs::WrenchStamped wrench =
      toMsg(ControlInput(1, 2, 3, 4), ros::Time(1, 0), "hummingbird/base_link");
  EXPECT_EQ(wrench.wrench.force.z, 1.0);
  EXPECT_EQ(wrench.wrench.torque.x, 2.0);
  EXPECT_EQ(wrench.wrench.torque.z, 4.0);
  geometry_msgs::Pose pose;
  pose.position.z = 3.0;
  pose.orientation.w = std::cos(0.5);
  pose.orientation.z = std::sin(0.5);
  EXPECT_EQ(fromMsg(pose).z, 3.0);
  EXPECT_NEAR(fromMsg(pose).yaw, 1.0, 1e-15);
}

}  // namespace
}  // namespace quad_control
