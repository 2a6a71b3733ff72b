// Messages and back.
#include <gtest/gtest.h>

#include "hummingbird.hpp"
#include "quad_sim_ros/conversions.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

TEST(Conversions, OdometryThereAndBack) {
  Odometry o;
  o.time_ns = 12345678901234;
  o.p_WB = {1.5, -2.25, 1e-17};
  o.q_WB = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
  o.v_WB_B = {0.1, 0.2, 0.3};
  o.w_WB_B = {-3, 2, -1};
  const nav_msgs::Odometry message = toMsg(o, "hummingbird/odometry_sensor1");
  EXPECT_EQ(message.header.frame_id, "world");
  EXPECT_EQ(message.child_frame_id, "hummingbird/odometry_sensor1");
  const Odometry back = fromMsg(message);
  EXPECT_EQ(back.time_ns, o.time_ns);
  EXPECT_EQ(back.p_WB, o.p_WB);
  EXPECT_EQ(back.q_WB.coeffs(), o.q_WB.coeffs());
  EXPECT_EQ(back.v_WB_B, o.v_WB_B);
  EXPECT_EQ(back.w_WB_B, o.w_WB_B);
}

TEST(Conversions, TimeZeroIsStampedOneNanosecond) {
  EXPECT_EQ(toStamp(0), ros::Time(0, 1));
  EXPECT_EQ(toTime(0), ros::Time(0, 0));
  EXPECT_EQ(toStamp(100000000), ros::Time(0, 100000000));
  EXPECT_EQ(toNanoseconds(toStamp(5000000001)), 5000000001);
  EXPECT_EQ(fromMsg(toMsg(Odometry{}, "x")).time_ns, 0);
  EXPECT_THROW(toStamp(-1), std::out_of_range);
  EXPECT_THROW(toStamp(5000000000LL * 1000000000LL), std::out_of_range);
}

TEST(Conversions, MotorSpeedsAreSignedOnTheWire) {
  const VehicleModel m = hummingbird();
  const std::vector<double> speeds = {401, 402, 403, 404};
  const mav_msgs::Actuators message = toMsg(speeds, m, 7, "hummingbird/base_link");
  EXPECT_EQ(message.angular_velocities, (std::vector<double>{-401, 402, -403, 404}));
  EXPECT_EQ(rotorSpeeds(message, m), speeds);
  mav_msgs::Actuators short_one;
  short_one.angular_velocities = {1};
  EXPECT_THROW(rotorSpeeds(short_one, m), quad_support::DataError);
}

}  // namespace
}  // namespace quad_sim
