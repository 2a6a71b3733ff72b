// The simulator node over ROS: each topic and service, lock-step by stamp, and the same bits as the
// library.
#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/SetModelState.h>
#include <gtest/gtest.h>
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <quad_sim/CommandReport.h>
#include <quad_sim/Step.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Float32.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <thread>

#include "quad_sim/simulation_config.hpp"
#include "quad_sim_ros/conversions.hpp"
#include "quad_sim_ros/persistent_call.hpp"

namespace {

using quad_sim::Step;

/// The first message of a topic that is there within five seconds of wall time.
template <class Message>
typename Message::ConstPtr next(const std::string& topic) {
  typename Message::ConstPtr got;
  ros::NodeHandle n;
  const boost::function<void(const typename Message::ConstPtr&)> take =
      [&](const typename Message::ConstPtr& m) {
        if (!got) got = m;
      };
  const ros::Subscriber subscriber = n.subscribe<Message>(topic, 1, take);
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (!got && ros::ok() && std::chrono::steady_clock::now() < limit) {
    ros::spinOnce();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return got;
}

bool same(const nav_msgs::Odometry& a, const nav_msgs::Odometry& b) {
  return a.header.stamp == b.header.stamp &&
         std::memcmp(&a.pose.pose, &b.pose.pose, sizeof(a.pose.pose)) == 0 &&
         std::memcmp(&a.twist.twist, &b.twist.twist, sizeof(a.twist.twist)) == 0;
}

class SimNode : public testing::Test {
 protected:
  void SetUp() override {
    command_ = n_.advertise<mav_msgs::Actuators>("/hummingbird/command/motor_speed", 10);
    ASSERT_TRUE(ros::service::waitForService("/gazebo/step", ros::Duration(10)));
    ASSERT_TRUE(call("/gazebo/pause_physics"));
    ASSERT_TRUE(call("/gazebo/reset_simulation"));
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (command_.getNumSubscribers() == 0 && std::chrono::steady_clock::now() < limit) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_GT(command_.getNumSubscribers(), 0U);
  }
  bool call(const std::string& service) {
    std_srvs::Empty empty;
    return quad_sim::persistentCall(service, empty);
  }
  void send(const ros::Time& stamp, const std::vector<double>& speeds) {
    mav_msgs::Actuators message;
    message.header.stamp = stamp;
    message.angular_velocities = speeds;
    command_.publish(message);
  }
  Step::Response step(std::uint32_t steps, std::uint32_t hold = 0, ros::Time stamp = ros::Time(),
                      double timeout = 5) {
    Step s;
    s.request.steps = steps;
    s.request.hold_steps = hold;
    s.request.command_stamp = stamp;
    s.request.timeout = timeout;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/step", s));
    return s.response;
  }
  /// A rough flight of `intervals` intervals in lock-step; the odometry after each.
  std::vector<nav_msgs::Odometry> fly(int intervals) {
    std::vector<nav_msgs::Odometry> log = {step(0).odometry};
    for (int k = 0; k < intervals; ++k) {
      send(log.back().header.stamp, speedsOf(k));
      const Step::Response answer = step(100, 45, log.back().header.stamp);
      EXPECT_TRUE(answer.success) << answer.message;
      log.push_back(answer.odometry);
    }
    return log;
  }
  static std::vector<double> speedsOf(int k) {
    return {465 + 5 * std::sin(k), 466 - 4 * std::cos(k), 464 + 3 * std::cos(k),
            465 - 5 * std::sin(k)};
  }
  /// The library at the node's start.
  static quad_sim::Simulator twin() {
    const quad_sim::SimulationConfig config = quad_sim::readSimulationConfig(configPath());
    return quad_sim::makeSimulator(config, config.model);
  }
  static std::string configPath() {
    std::string path;
    EXPECT_TRUE(ros::param::get("/gazebo/config", path));
    return path;
  }

  ros::NodeHandle n_;
  ros::Publisher command_;
};

TEST_F(SimNode, StepZeroAnswersThePresentState) {
  const Step::Response answer = step(0);
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.message, "");
  EXPECT_EQ(answer.stamp, ros::Time(0, 0));
  EXPECT_EQ(answer.odometry.header.stamp, ros::Time(0, 1));  // zero would mean "unset"
  EXPECT_EQ(answer.odometry.pose.pose.position.z, 5.0);
  EXPECT_EQ(answer.odometry.header.frame_id, "world");
  EXPECT_EQ(answer.odometry.child_frame_id, "hummingbird/odometry_sensor1");
  EXPECT_LT(answer.motor_speed.angular_velocities.at(0), -457);  // clockwise
  EXPECT_GT(answer.motor_speed.angular_velocities.at(1), 457);
}

TEST_F(SimNode, FliesTheSameBitsAsTheLibrary) {
  const std::vector<nav_msgs::Odometry> log = fly(30);
  quad_sim::Simulator simulator = twin();
  for (int k = 0; k < 30; ++k) {
    simulator.advance(45);
    simulator.setCommand(speedsOf(k));
    simulator.advance(55);
    const nav_msgs::Odometry expected = quad_sim::toMsg(simulator.measure().odometry, "x");
    EXPECT_TRUE(same(log[static_cast<std::size_t>(k) + 1], expected)) << "interval " << k;
  }
}

TEST_F(SimNode, ResetSimulationGivesTheSameBits) {
  const std::vector<nav_msgs::Odometry> first = fly(10);
  ASSERT_TRUE(call("/gazebo/reset_simulation"));
  const std::vector<nav_msgs::Odometry> second = fly(10);
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_TRUE(same(first[k], second[k])) << k;
  EXPECT_NE(first.back().pose.pose.position.z, first.front().pose.pose.position.z);
}

TEST_F(SimNode, ResetWorldKeepsTheTime) {
  fly(3);
  ASSERT_TRUE(call("/gazebo/reset_world"));
  const Step::Response answer = step(0);
  EXPECT_EQ(answer.stamp, ros::Time(0, 300000000));
  EXPECT_EQ(answer.odometry.pose.pose.position.z, 5.0);
}

TEST_F(SimNode, StepWaitsForTheCommandOfItsStamp) {
  const ros::Time stamp = step(0).odometry.header.stamp;
  std::thread controller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    send(ros::Time(0, 12345), {0, 0, 0, 0});  // somebody else's: must not be taken
    send(stamp, {600, 600, 600, 600});
  });
  const Step::Response answer = step(100, 0, stamp);
  controller.join();
  ASSERT_TRUE(answer.success) << answer.message;
  EXPECT_GT(answer.motor_speed.angular_velocities.at(1), 599);
}

TEST_F(SimNode, NoCommandIsATimeoutThatNamesTheStamp) {
  const Step::Response answer = step(100, 0, ros::Time(3, 50), 0.2);
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("no command stamped 3.000000050 s"), std::string::npos)
      << answer.message;
  EXPECT_EQ(answer.stamp, ros::Time(0, 0)) << "nothing may have run";
}

TEST_F(SimNode, WithoutAStampTheLatestCommandIsTaken) {
  send(ros::Time(9, 0), {700, 700, 700, 700});
  quad_sim::CommandReport report;  // it travels on a connection of its own
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (report.response.received == 0 && std::chrono::steady_clock::now() < limit) {
    ASSERT_TRUE(quad_sim::persistentCall("/gazebo/command_report", report));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const Step::Response answer = step(200);
  EXPECT_TRUE(answer.success);
  EXPECT_GT(answer.motor_speed.angular_velocities.at(1), 699);
}

TEST_F(SimNode, ImpossibleRequestsAreRefusedWithAReason) {
  EXPECT_NE(step(10, 11).message.find("hold_steps = 11; must be <= steps = 10"), std::string::npos);
  EXPECT_FALSE(step(10, 11).success);
  EXPECT_FALSE(step(10, 0, ros::Time(), -1).success);
  EXPECT_FALSE(step(10, 0, ros::Time(), std::nan("")).success);
  EXPECT_FALSE(step(4000000000U).success);
}

TEST_F(SimNode, ACommandOfWrongLengthOrNotANumberIsRefused) {
  const ros::Time stamp = step(0).odometry.header.stamp;
  send(stamp, {1, 2, 3});
  const Step::Response short_one = step(100, 0, stamp);
  EXPECT_FALSE(short_one.success);
  EXPECT_NE(short_one.message.find("3 rotor speeds; the vehicle has 4"), std::string::npos)
      << short_one.message;
  send(ros::Time(0, 2), {1, 2, 3, std::nan("")});
  const Step::Response nan_one = step(100, 0, ros::Time(0, 2));
  EXPECT_FALSE(nan_one.success);
  EXPECT_NE(nan_one.message.find("not a finite number"), std::string::npos) << nan_one.message;
  // The earlier command stays: it still hovers.
  EXPECT_NEAR(step(100).odometry.pose.pose.position.z, 5.0, 1e-9);
}

TEST_F(SimNode, TopicsCarryTheStateOfTheStep) {
  const nav_msgs::Odometry last = fly(2).back();
  const auto odometry =
      next<nav_msgs::Odometry>("/hummingbird/odometry_sensor1/odometry");  // latched
  ASSERT_TRUE(odometry);
  EXPECT_TRUE(same(*odometry, last));
  const auto motors = next<mav_msgs::Actuators>("/hummingbird/motor_speed");
  ASSERT_TRUE(motors);
  EXPECT_EQ(motors->header.stamp, last.header.stamp);
  const auto clock = next<rosgraph_msgs::Clock>("/clock");
  ASSERT_TRUE(clock);
  EXPECT_EQ(clock->clock, ros::Time(0, 200000000));
}

TEST_F(SimNode, OtherTopicsComeWhileItRuns) {
  ASSERT_TRUE(call("/gazebo/unpause_physics"));
  const auto relay = next<mav_msgs::Actuators>("/hummingbird/gazebo/command/motor_speed");
  ASSERT_TRUE(relay);
  EXPECT_NEAR(relay->angular_velocities.at(0), 457.4, 0.1);
  const auto transforms = next<tf2_msgs::TFMessage>("/tf");
  ASSERT_TRUE(transforms);
  EXPECT_EQ(transforms->transforms.at(0).header.frame_id, "world");
  EXPECT_EQ(transforms->transforms.at(0).child_frame_id, "hummingbird/odometry_sensor1");
  EXPECT_TRUE(next<nav_msgs::Odometry>("/hummingbird/ground_truth/odometry"));
  const auto slowed = next<std_msgs::Float32>("/hummingbird/motor_speed/0");
  ASSERT_TRUE(slowed);
  EXPECT_NEAR(slowed->data, -45.74, 0.01);
}

TEST_F(SimNode, RunsByTheWallClockUntilPaused) {
  gazebo_msgs::GetWorldProperties world;
  ASSERT_TRUE(call("/gazebo/unpause_physics"));
  const Step::Response refused = step(10);
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("running"), std::string::npos);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  ASSERT_TRUE(call("/gazebo/pause_physics"));
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/get_world_properties", world));
  // Half a second of wall time; a busy machine gives more, and less if it could not keep up.
  EXPECT_GT(world.response.sim_time, 0.25);
  EXPECT_LT(world.response.sim_time, 5.0);
  const auto odometry = next<nav_msgs::Odometry>("/hummingbird/odometry_sensor1/odometry");
  ASSERT_TRUE(odometry);
  EXPECT_NEAR(odometry->header.stamp.toSec(), world.response.sim_time, 1e-9)
      << "the state it stopped in is published";
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(step(0).odometry.header.stamp, odometry->header.stamp) << "paused means paused";
}

TEST_F(SimNode, ModelStateIsSetAndGot) {
  gazebo_msgs::SetModelState set;
  set.request.model_state.model_name = "hummingbird";
  set.request.model_state.pose.position.x = 1;
  set.request.model_state.pose.position.z = 7;
  set.request.model_state.pose.orientation.w = set.request.model_state.pose.orientation.z =
      std::sqrt(0.5);
  set.request.model_state.twist.linear.x = 2;
  set.request.model_state.twist.angular.z = 0.5;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_model_state", set));
  EXPECT_TRUE(set.response.success) << set.response.status_message;
  gazebo_msgs::GetModelState get;
  get.request.model_name = "hummingbird";
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/get_model_state", get));
  ASSERT_TRUE(get.response.success);
  EXPECT_NEAR(get.response.pose.position.x, 1, 1e-12);
  EXPECT_NEAR(get.response.pose.position.z, 7, 1e-12);
  EXPECT_NEAR(get.response.twist.linear.x, 2, 1e-12);
  EXPECT_NEAR(get.response.twist.angular.z, 0.5, 1e-12);
  EXPECT_NEAR(step(0).odometry.twist.twist.linear.y, -2, 1e-12)
      << "the odometry's twist is in body axes";
  get.request.model_name = set.request.model_state.model_name = "nobody";
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/get_model_state", get));
  EXPECT_FALSE(get.response.success);
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_model_state", set));
  EXPECT_FALSE(set.response.success);
}

TEST_F(SimNode, PropertiesAreThoseOfTheConfiguration) {
  gazebo_msgs::GetPhysicsProperties physics;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/get_physics_properties", physics));
  EXPECT_EQ(physics.response.time_step, 0.001);
  EXPECT_TRUE(physics.response.pause);
  EXPECT_EQ(physics.response.gravity.z, -9.8);
  gazebo_msgs::GetWorldProperties world;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/get_world_properties", world));
  EXPECT_EQ(world.response.model_names, (std::vector<std::string>{"ground_plane", "hummingbird"}));
}

TEST_F(SimNode, GroundContactIsToldByStep) {
  send(ros::Time(0, 1), {0, 0, 0, 0});
  const Step::Response answer = step(3000, 0, ros::Time(0, 1));
  EXPECT_TRUE(answer.success);
  // 4.94 m of free fall take 1.004 s; the rotors' run-down (25 ms) delays it a little.
  EXPECT_EQ(answer.message.rfind("ground contact at 1.0", 0), 0U) << answer.message;
  ASSERT_TRUE(call("/gazebo/reset_simulation"));
  EXPECT_EQ(step(0).message, "");
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_sim_node");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
