// The simulator node with two vehicles: every topic, saved states, physics properties, the tally of
// commands.
#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/ModelStates.h>
#include <gazebo_msgs/SetModelState.h>
#include <gazebo_msgs/SetPhysicsProperties.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <quad_sim/CommandReport.h>
#include <quad_sim/RestoreState.h>
#include <quad_sim/SaveState.h>
#include <quad_sim/Step.h>
#include <ros/ros.h>
#include <rotors_comm/WindSpeed.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Empty.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <thread>

#include "quad_sim/simulation_config.hpp"
#include "quad_sim_ros/conversions.hpp"
#include "quad_sim_ros/persistent_call.hpp"

namespace {

using quad_sim::Step;
using WallClock = std::chrono::steady_clock;

/// Waits up to ten seconds of wall time; on a busy machine connections take their time.
template <class Condition>
bool eventually(const Condition& condition) {
  const auto limit = WallClock::now() + std::chrono::seconds(10);
  while (!condition() && ros::ok() && WallClock::now() < limit) {
    ros::spinOnce();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

/// Listens to a topic from its construction on, once connected.
template <class Message>
class Listener {
 public:
  explicit Listener(const std::string& topic) {
    const boost::function<void(const typename Message::ConstPtr&)> take =
        [this](const typename Message::ConstPtr& m) { last = m; };
    subscriber_ = ros::NodeHandle().subscribe<Message>(topic, 10, take);
    EXPECT_TRUE(eventually([&] { return subscriber_.getNumPublishers() > 0; }))
        << "nobody publishes " << topic;
  }
  typename Message::ConstPtr last;

 private:
  ros::Subscriber subscriber_;
};

class Surface : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("/gazebo/restore_state", ros::Duration(20)));
    for (const char* bee : {"bee1", "bee2"}) {
      commands_[bee] =
          n_.advertise<mav_msgs::Actuators>(std::string("/") + bee + "/command/motor_speed", 10);
    }
    for (auto& entry : commands_) {
      ASSERT_TRUE(eventually([&] { return entry.second.getNumSubscribers() > 0; }));
    }
    ASSERT_TRUE(empty("/gazebo/pause_physics"));
    ASSERT_TRUE(empty("/gazebo/reset_simulation"));
  }
  bool empty(const std::string& service) {
    std_srvs::Empty call;
    return quad_sim::persistentCall(service, call);
  }
  void send(const std::string& bee, const ros::Time& stamp, const std::vector<double>& speeds) {
    mav_msgs::Actuators message;
    message.header.stamp = stamp;
    message.angular_velocities = speeds;
    commands_.at(bee).publish(message);
  }
  Step::Response step(std::uint32_t steps, ros::Time stamp = ros::Time(),
                      std::vector<std::string> wait_for = {}, double timeout = 10) {
    Step s;
    s.request.steps = steps;
    s.request.command_stamp = stamp;
    s.request.wait_for = std::move(wait_for);
    s.request.timeout = timeout;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/step", s));
    return s.response;
  }
  gazebo_msgs::GetModelState::Response modelState(const std::string& name,
                                                  const std::string& relative = "") {
    gazebo_msgs::GetModelState get;
    get.request.model_name = name;
    get.request.relative_entity_name = relative;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/get_model_state", get));
    return get.response;
  }
  quad_sim::CommandReport::Response report(const std::string& bee) {
    quad_sim::CommandReport call;
    call.request.model_name = bee;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/command_report", call));
    EXPECT_TRUE(call.response.success) << call.response.message;
    return call.response;
  }
  std::string save() {
    quad_sim::SaveState call;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/save_state", call));
    EXPECT_TRUE(call.response.success);
    return call.response.state;
  }
  quad_sim::RestoreState::Response restore(const std::string& state) {
    quad_sim::RestoreState call;
    call.request.state = state;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/restore_state", call));
    return call.response;
  }
  /// Lock-step flight of both; `from` picks the commands.
  void fly(int from, int to) {
    for (int k = from; k < to; ++k) {
      const ros::Time stamp = step(0).odometry.header.stamp;
      send("bee1", stamp,
           {465 + 5 * std::sin(k), 466 - 4 * std::cos(k), 464 + 3 * std::cos(k),
            465 - 5 * std::sin(k)});
      send("bee2", stamp, {430, 440 + 2 * std::sin(k), 430, 440});
      const Step::Response answer = step(45, stamp);
      ASSERT_TRUE(answer.success) << answer.message;
    }
  }

  ros::NodeHandle n_;
  std::map<std::string, ros::Publisher> commands_;
};

TEST_F(Surface, EveryTopicOfEachVehicle) {
  for (const std::string bee : {"bee1", "bee2"}) {
    SCOPED_TRACE(bee);
    const std::string sensor = "/" + bee + "/odometry_sensor1/";
    Listener<nav_msgs::Odometry> odometry(sensor + "odometry"),
        truth("/" + bee + "/ground_truth/odometry");
    Listener<geometry_msgs::Pose> pose(sensor + "pose");
    Listener<geometry_msgs::PoseWithCovarianceStamped> with_covariance(sensor +
                                                                       "pose_with_covariance");
    Listener<geometry_msgs::PointStamped> position(sensor + "position");
    Listener<geometry_msgs::TransformStamped> transform(sensor + "transform");
    Listener<sensor_msgs::Imu> imu("/" + bee + "/imu"), true_imu("/" + bee + "/ground_truth/imu");
    Listener<sensor_msgs::JointState> joints("/" + bee + "/joint_states");
    Listener<rotors_comm::WindSpeed> wind("/" + bee + "/wind_speed");
    Listener<mav_msgs::Actuators> relay("/" + bee + "/gazebo/command/motor_speed");
    Listener<gazebo_msgs::ModelStates> models("/gazebo/model_states");
    // Stepped until all are connected at the simulator's end, too.
    ASSERT_TRUE(eventually([&] {
      step(10);
      ros::spinOnce();
      return odometry.last && truth.last && pose.last && with_covariance.last && position.last &&
             transform.last && imu.last && true_imu.last && joints.last && wind.last &&
             relay.last && models.last;
    }));
    const ros::Time now = step(10).odometry.header.stamp;
    ASSERT_TRUE(eventually([&] {
      return odometry.last->header.stamp == now && position.last->header.stamp == now &&
             imu.last->header.stamp == now && transform.last->header.stamp == now &&
             joints.last->header.stamp == now && true_imu.last->header.stamp == now;
    }));
    EXPECT_EQ(odometry.last->child_frame_id, bee + "/odometry_sensor1");
    EXPECT_EQ(truth.last->child_frame_id, bee + "/base_link");
    const double x = bee == "bee1" ? 0 : 2;
    EXPECT_NEAR(odometry.last->pose.pose.position.x, x, 1e-9);
    EXPECT_EQ(pose.last->position.x, odometry.last->pose.pose.position.x);
    EXPECT_EQ(with_covariance.last->pose.pose.position.z, odometry.last->pose.pose.position.z);
    EXPECT_EQ(position.last->point.z, odometry.last->pose.pose.position.z);
    EXPECT_EQ(transform.last->child_frame_id, bee + "/odometry_sensor1");
    EXPECT_EQ(imu.last->header.frame_id, bee + "/imu_link");
    EXPECT_EQ(imu.last->orientation_covariance[0], 0) << "not -1: the orientation is there";
    // Turn-on bias 0.196, white noise 0.04 m/s²: five sigma.
    EXPECT_NEAR(imu.last->linear_acceleration.z, 9.8, 1.0);
    EXPECT_NE(imu.last->linear_acceleration.z, true_imu.last->linear_acceleration.z);
    EXPECT_NEAR(true_imu.last->linear_acceleration.z, 9.8, 1e-6);
    EXPECT_EQ(joints.last->name.size(), 4U);
    EXPECT_LT(joints.last->position.at(0) * joints.last->position.at(1), 0)
        << "neighbours turn opposite ways";
    EXPECT_EQ(wind.last->velocity.x, 0);
    EXPECT_EQ(relay.last->angular_velocities.size(), 4U);
    EXPECT_EQ(models.last->name, (std::vector<std::string>{"bee1", "bee2"}));
    EXPECT_NEAR(models.last->pose.at(1).position.x, 2, 1e-9);
  }
}

TEST_F(Surface, VehiclesFlyEachOnItsOwnCommands) {
  fly(0, 20);
  const double higher = modelState("bee1").pose.position.z - 5,
               lower = modelState("bee2").pose.position.z - 6;
  EXPECT_GT(higher, 0.05);
  EXPECT_LT(lower, -0.05);
}

TEST_F(Surface, StepWaitsForAllVehiclesOrForThoseNamed) {
  const ros::Time stamp = step(0).odometry.header.stamp;
  send("bee1", stamp, {600, 600, 600, 600});
  const Step::Response all = step(10, stamp, {}, 2);
  EXPECT_FALSE(all.success);
  EXPECT_NE(all.message.find("/bee2/command/motor_speed"), std::string::npos) << all.message;
  EXPECT_TRUE(step(10, stamp, {"bee1"}).success);
  EXPECT_NE(step(10, stamp, {"wasp"}).message.find("no vehicle 'wasp'"), std::string::npos);
}

TEST_F(Surface, SavedStateContinuesBitForBitHereAndElsewhere) {
  fly(0, 10);
  const std::string saved = save();
  fly(10, 20);
  const std::string after = save();
  ASSERT_TRUE(empty("/gazebo/reset_simulation"));
  ASSERT_TRUE(restore(saved).success);
  EXPECT_EQ(save(), saved);
  fly(10, 20);
  EXPECT_EQ(save(), after);

  // Elsewhere: the first vehicle, in the library, by the same commands.
  std::string path;
  ASSERT_TRUE(ros::param::get("/gazebo/config", path));
  const quad_sim::SimulationConfig config = quad_sim::readSimulationConfig(path);
  quad_sim::Simulator twin = quad_sim::makeSimulator(config, config.model);
  const auto firstVehicle = [](const std::string& world) {
    std::istringstream in(world);
    std::string line, text;
    std::getline(in, line);
    for (int i = 0; i < 4 && std::getline(in, line); ++i) text += line + "\n";
    return text;
  };
  twin.restore(quad_sim::savedStateFromText(firstVehicle(saved)));
  for (int k = 10; k < 20; ++k) {
    twin.setCommand({465 + 5 * std::sin(k), 466 - 4 * std::cos(k), 464 + 3 * std::cos(k),
                     465 - 5 * std::sin(k)});
    twin.advance(45);
  }
  EXPECT_EQ(quad_sim::toText(twin.save()), firstVehicle(after));
}

TEST_F(Surface, AStateThatDoesNotFitChangesNothing) {
  fly(0, 3);
  const std::string before = save();
  EXPECT_NE(restore("nonsense").message.find("where 'vehicle bee1' should be"), std::string::npos);
  EXPECT_FALSE(restore(before + "more").success);
  EXPECT_FALSE(restore(before.substr(0, before.size() / 2)).success);
  EXPECT_EQ(save(), before);
}

TEST_F(Surface, TwoRunsAfterResetAreTwoFreshRuns) {
  const std::string fresh = save();
  fly(0, 10);
  const std::string first = save();
  ASSERT_TRUE(empty("/gazebo/reset_simulation"));
  EXPECT_EQ(save(), fresh);
  fly(0, 10);
  EXPECT_EQ(save(), first);
}

TEST_F(Surface, PhysicsPropertiesAreSetAndGot) {
  gazebo_msgs::SetPhysicsProperties set;
  set.request.time_step = 0.002;
  set.request.max_update_rate = 1000;
  set.request.gravity.z = -3;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_physics_properties", set));
  ASSERT_TRUE(set.response.success) << set.response.status_message;
  gazebo_msgs::GetPhysicsProperties get;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/get_physics_properties", get));
  EXPECT_EQ(get.response.time_step, 0.002);
  EXPECT_EQ(get.response.gravity.z, -3);
  EXPECT_NEAR(get.response.max_update_rate, 1000, 1e-9);
  EXPECT_EQ(step(50).stamp, ros::Time(0, 100000000));
  EXPECT_NEAR(modelState("bee1").twist.linear.z, 6.8 * 0.1, 1e-6)
      << "hovering for 9.8 m/s², with 3";
  const auto refused = [&](double time_step, double rate, double gx, double gz) {
    set.request.time_step = time_step;
    set.request.max_update_rate = rate;
    set.request.gravity.x = gx;
    set.request.gravity.z = gz;
    EXPECT_TRUE(quad_sim::persistentCall("/gazebo/set_physics_properties", set));
    EXPECT_FALSE(set.response.success);
    return set.response.status_message;
  };
  EXPECT_NE(refused(0.001, -1, 0, -9.8).find("max_update_rate = -1 Hz; must be >= 0"),
            std::string::npos);
  EXPECT_NE(refused(0.001, 1000, 1, -9.8).find("must be (0, 0, <= 0)"), std::string::npos);
  EXPECT_NE(refused(0.003, 1000, 0, -9.8).find("must be a whole number of it"), std::string::npos);
  EXPECT_NE(refused(std::nan(""), 1000, 0, -9.8).find("simulation.step"), std::string::npos);
  ASSERT_TRUE(empty("/gazebo/reset_simulation"));
  set.request.time_step = 0.001;
  set.request.max_update_rate = 1000;
  set.request.gravity.x = 0;
  set.request.gravity.z = -9.8;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_physics_properties", set));
  EXPECT_TRUE(set.response.success) << set.response.status_message;
}

TEST_F(Surface, CommandsThatAreNotFlownAsTheyCameAreCounted) {
  const ros::Time first = step(0).odometry.header.stamp;
  send("bee1", first, {458, 458, 458, 458});
  const ros::Time second = step(10, first, {"bee1"}).odometry.header.stamp;
  send("bee1", second, {500, 500, 500, 500});
  ASSERT_TRUE(step(10, second, {"bee1"}).success);
  const auto sendAndWait = [&](const ros::Time& stamp, const std::vector<double>& speeds) {
    const auto before = report("bee1").received;
    send("bee1", stamp, speeds);
    ASSERT_TRUE(eventually([&] { return report("bee1").received > before; }));
  };
  sendAndWait(first, {0, 0, 0, 0});
  sendAndWait(second, {1, 2, 3});
  sendAndWait(second, {1, 2, 3, std::nan("")});
  sendAndWait(second, {-5, 458, 458, 458});
  sendAndWait(second, {458, 458, 458, 5000});
  const auto tally = report("bee1");
  EXPECT_EQ(tally.received, 7U);
  EXPECT_EQ(tally.late, 1U);
  EXPECT_EQ(tally.wrong_length, 1U);
  EXPECT_EQ(tally.not_finite, 1U);
  EXPECT_EQ(tally.negative, 1U);
  EXPECT_EQ(tally.over_limit, 1U);
  EXPECT_NE(tally.last_problem.find("above the rotor's maximum"), std::string::npos)
      << tally.last_problem;
  const auto speeds = step(500).motor_speed.angular_velocities;  // the latest usable command
  EXPECT_NEAR(speeds.at(3), 838, 1e-3);
  EXPECT_NEAR(speeds.at(1), 458, 1e-3);
  EXPECT_EQ(report("bee2").received, 0U);
  ASSERT_TRUE(empty("/gazebo/reset_simulation"));
  EXPECT_EQ(report("bee1").received, 0U);
}

TEST_F(Surface, AVehicleIsSeenAndSetRelativeToAnother) {
  const auto relative = modelState("bee1", "bee2");  // bee2 stands at (2, 1, 6) and looks along y
  ASSERT_TRUE(relative.success);
  EXPECT_NEAR(relative.pose.position.x, -1, 1e-12);
  EXPECT_NEAR(relative.pose.position.y, 2, 1e-12);
  EXPECT_NEAR(relative.pose.position.z, -1, 1e-12);
  gazebo_msgs::SetModelState set;
  set.request.model_state.model_name = "bee1";
  set.request.model_state.reference_frame = "bee2";
  set.request.model_state.pose.position.x = 3;
  set.request.model_state.pose.orientation.w = 1;
  set.request.model_state.twist.linear.x = 1;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_model_state", set));
  ASSERT_TRUE(set.response.success) << set.response.status_message;
  const auto now = modelState("bee1");
  EXPECT_NEAR(now.pose.position.x, 2, 1e-12);
  EXPECT_NEAR(now.pose.position.y, 4, 1e-12);
  EXPECT_NEAR(now.twist.linear.y, 1, 1e-12);
  set.request.model_state.pose.orientation.w = 0;
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_model_state", set));
  EXPECT_NE(set.response.status_message.find("orientation must not be zero"), std::string::npos);
  set.request.model_state.pose.orientation.w = 1;
  set.request.model_state.pose.position.x = std::nan("");
  ASSERT_TRUE(quad_sim::persistentCall("/gazebo/set_model_state", set));
  EXPECT_FALSE(set.response.success);
  EXPECT_NE(modelState("wasp").status_message.find(
                "no model 'wasp'; in the world there is 'bee1', 'bee2'"),
            std::string::npos);
}

TEST_F(Surface, ModelStateAndWindComeByTopicToo) {
  const ros::Publisher models = n_.advertise<gazebo_msgs::ModelState>("/gazebo/set_model_state", 1);
  const ros::Publisher winds = n_.advertise<rotors_comm::WindSpeed>("/bee2/wind_speed", 1);
  ASSERT_TRUE(
      eventually([&] { return models.getNumSubscribers() > 0 && winds.getNumSubscribers() > 0; }));
  gazebo_msgs::ModelState state;
  state.model_name = "bee1";
  state.pose.position.z = 9;
  state.pose.orientation.w = 1;
  models.publish(state);
  EXPECT_TRUE(eventually([&] { return std::abs(modelState("bee1").pose.position.z - 9) < 1e-9; }));
  rotors_comm::WindSpeed wind;
  wind.velocity.x = 4;
  winds.publish(wind);
  EXPECT_TRUE(eventually([&] {  // the air takes the vehicle along; bee1 has none
    step(10);
    return modelState("bee2").twist.linear.x > 0.01;
  }));
  EXPECT_NEAR(modelState("bee1").twist.linear.x, 0, 1e-9);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_ros_surface");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
