#include "vehicle_topics.hpp"

#include <fmt/core.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float32.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

const PluginDeclaration* windPlugin(const VehicleModel& model) {
  for (const PluginDeclaration& p : model.plugins) {
    if (p.filename == "librotors_gazebo_wind_plugin.so") return &p;
  }
  return nullptr;
}

rotors_comm::WindSpeed windMessage(const Simulator& simulator) {
  rotors_comm::WindSpeed out;
  out.header.stamp = toStamp(simulator.timeNanoseconds());
  out.header.frame_id = "world";
  const Eigen::Vector3d v = simulator.wind();
  out.velocity.x = v.x();
  out.velocity.y = v.y();
  out.velocity.z = v.z();
  return out;
}

geometry_msgs::WrenchStamped forceMessage(const Simulator& simulator, const std::string& frame) {
  geometry_msgs::WrenchStamped out;
  out.header.stamp = toStamp(simulator.timeNanoseconds());
  out.header.frame_id = frame;
  const Eigen::Vector3d f = simulator.outsideForce();
  out.wrench.force.x = f.x();
  out.wrench.force.y = f.y();
  out.wrench.force.z = f.z();
  return out;
}

std::string forceFrame(const VehicleModel& model, const std::string& vehicle) {
  const PluginDeclaration* const wind = windPlugin(model);
  return wind ? frameOf(*wind, wind->text("frameId", "world"), vehicle) : "world";
}

std::string windSpeedTopic(const VehicleModel& model) {
  const PluginDeclaration* const wind = windPlugin(model);
  return wind ? wind->text("windSpeedPubTopic", "wind_speed") : "wind_speed";
}

VehicleTopics::VehicleTopics(const Simulator& simulator, const std::string& name,
                             ros::NodeHandle& n)
    : simulator_(simulator), name_(name) {
  constexpr int kQueueLength = 10;
  const VehicleModel& model = simulator.model();
  const std::string ns = "/" + name + "/";
  motor_speed_pub_ = n.advertise<mav_msgs::Actuators>(ns + "motor_speed", kQueueLength, true);
  relay_pub_ = n.advertise<mav_msgs::Actuators>(ns + "gazebo/command/motor_speed", kQueueLength);
  joints_pub_ = n.advertise<sensor_msgs::JointState>(ns + "joint_states", kQueueLength);
  const PluginDeclaration* const wind = windPlugin(model);
  wind_pub_ = n.advertise<rotors_comm::WindSpeed>(ns + windSpeedTopic(model), kQueueLength);
  if (wind) {
    const std::string usual = wind->text("windPubTopic", "external_force");  // the tag's older name
    force_pub_ = n.advertise<geometry_msgs::WrenchStamped>(
        ns + wind->text("windForcePubTopic", usual), kQueueLength);
    force_frame_ = forceFrame(model, name);
  }
  tf_pub_ = n.advertise<tf2_msgs::TFMessage>("/tf", 100);
  for (const SensorModel& sensor : model.sensors) {
    if (sensor.kind == SensorModel::Kind::kImu) {
      imus_.push_back(std::make_unique<ImuTopic>(sensor, simulator, name, n));
    } else {
      odometry_.push_back(
          std::make_unique<OdometryTopics>(sensor, simulator, name, n, odometry_.empty()));
    }
  }
  if (odometry_.empty()) {
    throw std::invalid_argument(name +
                                ": no odometry sensor; controllers over ROS need one "
                                "(librotors_gazebo_odometry_plugin.so)");
  }
  for (const RotorModel& rotor : model.rotors) {
    rotor_pubs_.push_back(n.advertise<std_msgs::Float32>(
        fmt::format("{}motor_speed/{}", ns, rotor.motor_number), kQueueLength));
  }
  start();
}

void VehicleTopics::start() {
  angle_.assign(rotor_pubs_.size(), 0.0);
  speed_before_ = simulator_.measure().rotor_speed;
  turned_ns_ = simulator_.timeNanoseconds();
  for (auto& sensor : odometry_) sensor->renew();
  atEvent();
}

void VehicleTopics::renew() {
  for (auto& sensor : odometry_) sensor->renew();
  for (auto& imu : imus_) imu->renew();
}

std::int64_t VehicleTopics::nextEvent() const {
  const std::int64_t now = simulator_.stepCount();
  std::int64_t next = OdometryTopics::kNever;
  for (const auto& sensor : odometry_) next = std::min(next, sensor->nextEvent(now));
  for (const auto& imu : imus_) next = std::min(next, imu->nextEvent(now));
  return next;
}

void VehicleTopics::atEvent() {
  const std::int64_t now = simulator_.stepCount();
  for (auto& imu : imus_) imu->atEvent(now);
  for (auto& sensor : odometry_) sensor->atEvent(now, tf_pub_);
}

void VehicleTopics::publish() {
  const std::vector<double> speed = simulator_.measure().rotor_speed;
  last_motor_speed_ =
      toMsg(speed, simulator_.model(), simulator_.timeNanoseconds(), name_ + "/base_link");
  motor_speed_pub_.publish(last_motor_speed_);
  const bool tf_wanted = tf_pub_.getNumSubscribers() > 0;
  tf2_msgs::TFMessage transforms;
  for (auto& sensor : odometry_)
    sensor->publish(tf_wanted, transforms);  // after the motor speeds: controllers start on them
  if (tf_wanted && !transforms.transforms.empty()) tf_pub_.publish(transforms);
  turnRotors(speed);
  publishRotors(speed);
  publishHeld();
}

/// The angles of the joints that RotorS turns `slowdown` times slower; between publications the
/// speed counts as changing evenly. For drawing: nothing in the physics needs them.
void VehicleTopics::turnRotors(const std::vector<double>& speed) {
  const double dt = static_cast<double>(simulator_.timeNanoseconds() - turned_ns_) * 1e-9;
  for (std::size_t i = 0; i < angle_.size(); ++i) {
    const RotorModel& rotor = simulator_.model().rotors[i];
    constexpr double kTurn = 6.283185307179586;
    angle_[i] = std::remainder(
        angle_[i] + 0.5 * dt * rotor.spin * (speed_before_[i] + speed[i]) / rotor.slowdown, kTurn);
  }
  speed_before_ = speed;
  turned_ns_ = simulator_.timeNanoseconds();
}

void VehicleTopics::publishRotors(const std::vector<double>& speed) {
  const std::vector<RotorModel>& rotors = simulator_.model().rotors;
  for (std::size_t i = 0; i < rotor_pubs_.size(); ++i) {
    if (rotor_pubs_[i].getNumSubscribers() == 0) continue;
    std_msgs::Float32 joint_speed;  // RotorS publishes the slowed joint's speed here
    joint_speed.data = static_cast<float>(rotors[i].spin * speed[i] / rotors[i].slowdown);
    rotor_pubs_[i].publish(joint_speed);
  }
  if (joints_pub_.getNumSubscribers() == 0) return;
  sensor_msgs::JointState joints;
  joints.header.stamp = last_motor_speed_.header.stamp;
  for (const RotorModel& rotor : rotors) joints.name.push_back(rotor.joint);
  joints.position = angle_;
  joints_pub_.publish(joints);
}

/// What is in force: the command the motors follow, and the wind. The node listens to both topics
/// itself.
void VehicleTopics::publishHeld() {
  constexpr std::uint32_t kOwn = 1;
  if (relay_pub_.getNumSubscribers() > kOwn) {
    mav_msgs::Actuators relay;
    relay.header.stamp = last_motor_speed_.header.stamp;
    relay.angular_velocities = simulator_.command();
    relay_pub_.publish(relay);
  }
  if (wind_pub_.getNumSubscribers() > kOwn) {
    wind_pub_.publish(windMessage(simulator_));
  }
  if (force_pub_ && force_pub_.getNumSubscribers() > 0)
    force_pub_.publish(forceMessage(simulator_, force_frame_));
}

void VehicleTopics::archive(StateArchive& archive) {
  for (auto& sensor : odometry_) sensor->archive(archive);
  for (double& angle : angle_) archive(angle);
  for (double& speed : speed_before_) archive(speed);
  archive(turned_ns_);
}

}  // namespace quad_sim
