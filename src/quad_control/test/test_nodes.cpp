// The nodes as the experiment uses them, in lock-step with the real simulator.
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "../src/ros/conversions.hpp"
#include "quad_control/Advance.h"
#include "quad_control/Begin.h"
#include "quad_control/FlightRecord.h"
#include "quad_control/SetFlightPlan.h"
#include "quad_control/TimingReport.h"
#include "quad_sim/simulation_config.hpp"
#include "quad_sim/simulator.hpp"
#include "quad_sim_ros/persistent_call.hpp"

namespace quad_control {
namespace {

constexpr int kSteps = 100, kLatencySteps = 45, kHold = 5;
constexpr double kEstimate = 0.6247;
const std::vector<double> kSignal = {0.5, -1.0, 1.5, -2.0, 2.5};

std::string configPath() { return ros::param::param<std::string>("~config", ""); }

template <class Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request) {
  Service service;
  service.request = request;
  EXPECT_TRUE(quad_sim::persistentCall("/hummingbird/" + name, service)) << name;
  return service.response;
}

Begin::Response begin() {
  Begin::Request request;
  request.timeout = 10.0;
  return call<Begin>("time_manager/begin", request);
}

Advance::Request interval(int steps = kSteps, int hold_steps = kLatencySteps) {
  Advance::Request request;
  request.steps = static_cast<std::uint32_t>(steps);
  request.hold_steps = static_cast<std::uint32_t>(hold_steps);
  request.timeout = 5.0;
  return request;
}

Advance::Response advance() { return call<Advance>("time_manager/advance", interval()); }

TimingReport::Response end() {
  TimingReport::Request request;
  request.timeout = 5.0;
  return call<TimingReport>("time_manager/end", request);
}

SetFlightPlan::Request plan() {
  SetFlightPlan::Request request;
  request.z = 5000.0;
  request.feed_forward_mass = kEstimate;
  request.initial_altitude_effort = equilibriumEffort(0.73, kEstimate, 9.8);
  request.exploration_start = quad_sim::toStamp(std::int64_t{kHold} * 100'000'000);
  request.exploration_signal = kSignal;
  return request;
}

struct Row {
  std::int64_t time_ns;
  double z, vz;
  std::vector<double> rotor_speed;
  bool operator==(const Row& o) const {
    return time_ns == o.time_ns && z == o.z && vz == o.vz && rotor_speed == o.rotor_speed;
  }
};

Row row(const nav_msgs::Odometry& odometry, std::vector<double> speed) {
  for (double& w : speed) w = std::abs(w);
  return {quad_sim::simulatedTime(odometry.header.stamp), odometry.pose.pose.position.z,
          odometry.twist.twist.linear.z, speed};
}

class Nodes : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const char* name :
         {"controller/set_flight_plan", "controller/flight_record", "time_manager/begin"}) {
      const std::string service = std::string("/hummingbird/") + name;
      for (int i = 0; i < 1000 && !ros::service::exists(service, false); ++i)
        ros::WallDuration(0.02).sleep();
      ASSERT_TRUE(ros::service::exists(service, true));
    }
  }

  std::vector<Row> fly(int intervals) {
    const SetFlightPlan::Response accepted =
        call<SetFlightPlan>("controller/set_flight_plan", plan());
    EXPECT_TRUE(accepted.success) << accepted.message;
    const Begin::Response first = begin();
    EXPECT_TRUE(first.success) << first.message;
    std::vector<Row> rows = {row(first.odometry, first.motor_speed.angular_velocities)};
    for (int k = 0; k < intervals; ++k) {
      const Advance::Response next = advance();
      EXPECT_TRUE(next.success) << next.message;
      if (!next.success) break;
      rows.push_back(row(next.odometry, next.motor_speed.angular_velocities));
    }
    return rows;
  }

  static std::vector<Row> flyInProcess(int intervals) {
    const quad_sim::SimulationConfig config = quad_sim::readSimulationConfig(configPath());
    const quad_sim::VehicleModel model = config.model;
    quad_sim::Simulator simulator = quad_sim::makeSimulator(config, model);
    const auto control = quad_support::ConfigReader::fromFile(configPath()).section("control");
    FlightController controller(model, readControlConfig(control, 0.1));
    controller.begin(fromMsg(plan(), 9.8));
    std::vector<Row> rows;
    for (int k = 0; k <= intervals; ++k) {
      const quad_sim::Measurement now = simulator.measure();
      rows.push_back(
          {now.odometry.time_ns, now.odometry.p_WB.z(), now.odometry.v_WB_B.z(), now.rotor_speed});
      simulator.advance(kLatencySteps);
      simulator.setCommand(controller.update(now.odometry).rotor_speed);
      simulator.advance(kSteps - kLatencySteps);
    }
    return rows;
  }
};

TEST_F(Nodes, FlyTheSameBitsAsTheLibraryTwice) {
  const std::vector<Row> expected = flyInProcess(30);
  for (int flight = 0; flight < 2; ++flight) {
    SCOPED_TRACE(flight);
    const std::vector<Row> rows = fly(30);
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      EXPECT_TRUE(rows[k] == expected[k]) << "row " << k;
    const TimingReport::Response report = end();
    ASSERT_TRUE(report.success) << report.message;
    EXPECT_EQ(report.mode, "lockstep");
    EXPECT_EQ(report.intervals, 30u);
    EXPECT_EQ(report.desired, 0.1);
    // Intervals are exact; differences of nanosecond times scaled by 1e-9 round in the last digit.
    EXPECT_NEAR(report.mean, 0.1, 1e-15);
    EXPECT_NEAR(report.max_abs_error, 0.0, 1e-15);
  }
}

TEST_F(Nodes, RecordHasEveryCommandOnce) {
  const std::vector<Row> rows = fly(20);
  ASSERT_TRUE(end().success);
  const FlightRecord::Response record = call<FlightRecord>("controller/flight_record", {});
  ASSERT_TRUE(record.success);
  ASSERT_EQ(record.time.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(quad_sim::simulatedTime(record.time[k]), rows[k].time_ns);
    const bool in_signal = k >= kHold && k < kHold + kSignal.size();
    if (k >= kHold) {
      EXPECT_EQ(record.t_eff[k], in_signal ? kSignal[k - kHold] : 0.0) << k;
    }
    EXPECT_EQ(record.clamped[k], 0u);
  }
  EXPECT_NEAR(record.thrust[0], 0.73 * 9.8, 1e-12);
  EXPECT_EQ(record.tau_phi.size(), rows.size());
}

TEST_F(Nodes, PublishTheInputAndItsReconstruction) {
  ros::NodeHandle handle;
  std::vector<geometry_msgs::WrenchStamped> u, u_fb;
  const ros::Subscriber u_sub = handle.subscribe<geometry_msgs::WrenchStamped>(
      "/hummingbird/control/u", 100,
      [&u](const geometry_msgs::WrenchStamped::ConstPtr& m) { u.push_back(*m); });
  const ros::Subscriber fb_sub = handle.subscribe<geometry_msgs::WrenchStamped>(
      "/hummingbird/control/u_fb", 100,
      [&u_fb](const geometry_msgs::WrenchStamped::ConstPtr& m) { u_fb.push_back(*m); });
  for (int i = 0; i < 500 && (u_sub.getNumPublishers() == 0 || fb_sub.getNumPublishers() == 0);
       ++i) {
    ros::WallDuration(0.01).sleep();
  }
  fly(3);
  ASSERT_TRUE(end().success);
  const auto complete = [&] { return u.size() >= 4 && u_fb.size() >= 4; };
  for (int i = 0; i < 500 && !complete(); ++i)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  ASSERT_TRUE(complete()) << u.size() << " " << u_fb.size();
  // In the hold both are m g; the reconstruction goes through a square root and a square.
  EXPECT_NEAR(u.front().wrench.force.z, 0.73 * 9.8, 1e-9);
  EXPECT_NEAR(u_fb.front().wrench.force.z, 0.73 * 9.8, 1e-9);
  EXPECT_NEAR(u_fb.front().wrench.torque.x, 0.0, 1e-9);
}

TEST_F(Nodes, SayWhatIsWrong) {
  SetFlightPlan::Request bad = plan();
  bad.feed_forward_mass = -1.0;
  const SetFlightPlan::Response refused = call<SetFlightPlan>("controller/set_flight_plan", bad);
  EXPECT_FALSE(refused.success);
  EXPECT_EQ(refused.message, "flight plan: feed_forward_mass = -1; must be > 0 kg");
  fly(2);
  ASSERT_TRUE(end().success);
  const Advance::Response after_end = advance();
  EXPECT_FALSE(after_end.success);
  EXPECT_EQ(after_end.message, "no flight has begun; call the service begin first");
  fly(1);
  const Advance::Response too_long = call<Advance>("time_manager/advance", interval(10, 11));
  EXPECT_FALSE(too_long.success);
  EXPECT_NE(too_long.message.find("hold_steps"), std::string::npos) << too_long.message;
  EXPECT_TRUE(advance().success);  // a refused step changes nothing
  ASSERT_TRUE(end().success);
}

TEST_F(Nodes, PoseCommandMovesTheReference) {
  ros::NodeHandle handle;
  ros::Publisher pose_pub =
      handle.advertise<geometry_msgs::PoseStamped>("/hummingbird/command/pose", 1);
  SetFlightPlan::Request hold = plan();
  hold.exploration_signal.clear();  // a hold that goes on
  ASSERT_TRUE(call<SetFlightPlan>("controller/set_flight_plan", hold).success);
  ASSERT_TRUE(begin().success);
  for (int i = 0; i < 500 && pose_pub.getNumSubscribers() == 0; ++i)
    ros::WallDuration(0.01).sleep();
  geometry_msgs::PoseStamped pose;
  pose.pose.position.z = 5001.0;
  pose.pose.orientation.w = 1.0;
  Advance::Response last;
  for (int k = 0; k < 60; ++k) {
    pose_pub.publish(pose);  // a topic has no acknowledgement: said again, it may come late once
    last = advance();
  }
  EXPECT_NEAR(last.odometry.pose.pose.position.z, 5001.0, 0.05);  // settled to 2 % after 2.4 s
  ASSERT_TRUE(end().success);
}

TEST_F(Nodes, StepRate) {
  ASSERT_TRUE(call<SetFlightPlan>("controller/set_flight_plan", plan()).success);
  ASSERT_TRUE(begin().success);
  ros::NodeHandle handle;
  ros::ServiceClient client =
      handle.serviceClient<Advance>("/hummingbird/time_manager/advance", true);
  constexpr int kCount = 2000;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < kCount; ++k) {
    Advance call;
    call.request = interval(100, 45);
    ASSERT_TRUE(client.call(call) && call.response.success) << call.response.message;
    if (k % 200 == 199) {  // start again before the fall ends on the ground
      ASSERT_TRUE(end().success);
      ASSERT_TRUE(begin().success);
    }
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << kCount / seconds
            << " control steps/s through time manager, simulator and controller\n";
  RecordProperty("steps_per_second", static_cast<int>(kCount / seconds));
  ASSERT_TRUE(end().success);
}

}  // namespace
}  // namespace quad_control

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_nodes");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
