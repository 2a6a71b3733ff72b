// The time manager with no simulator to manage.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "quad_control/Begin.h"
#include "quad_sim_ros/persistent_call.hpp"

TEST(NoSimulator, BeginSaysSoWithinItsTimeout) {
  for (int i = 0; i < 1000 && !ros::service::exists("/time_manager/begin", false); ++i)
    ros::WallDuration(0.02).sleep();
  quad_control::Begin begin;
  begin.request.timeout = 0.2;
  ASSERT_TRUE(quad_sim::persistentCall("/time_manager/begin", begin));
  EXPECT_FALSE(begin.response.success);
  EXPECT_EQ(
      begin.response.message,
      "/gazebo/step does not answer: the simulator is gone or was never started (quad_sim_node)");
  begin.request.timeout = 0.0;
  ASSERT_TRUE(quad_sim::persistentCall("/time_manager/begin", begin));
  EXPECT_EQ(begin.response.message, "timeout = 0 s; must be > 0 s");
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_no_simulator");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
