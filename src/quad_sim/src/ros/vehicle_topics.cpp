#include "vehicle_topics.hpp"

#include <fmt/core.h>
#include <std_msgs/Float32.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <stdexcept>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

VehicleTopics::VehicleTopics(const Simulator& simulator, const std::string& name,
                             const ros::NodeHandle& handle)
    : simulator_(simulator), name_(name) {
  constexpr int kQueueLength = 10;
  const VehicleModel& model = simulator.model();
  const auto is_odometry = [](const SensorModel& s) {
    return s.kind == SensorModel::Kind::kOdometry;
  };
  const auto first = std::find_if(model.sensors.begin(), model.sensors.end(), is_odometry);
  if (first == model.sensors.end()) {
    throw std::invalid_argument(name +
                                ": no odometry sensor; controllers over ROS need one "
                                "(librotors_gazebo_odometry_plugin.so)");
  }
  primary_ = &*first;
  ros::NodeHandle n = handle;
  const std::string ns = "/" + name + "/";
  odometry_pub_ = n.advertise<nav_msgs::Odometry>(ns + primary_->topic, kQueueLength, true);
  motor_speed_pub_ = n.advertise<mav_msgs::Actuators>(ns + "motor_speed", kQueueLength, true);
  relay_pub_ = n.advertise<mav_msgs::Actuators>(ns + "gazebo/command/motor_speed", kQueueLength);
  tf_pub_ = n.advertise<tf2_msgs::TFMessage>("/tf", 100);
  for (const SensorModel& sensor : model.sensors) {
    if (sensor.kind != SensorModel::Kind::kOdometry || &sensor == primary_) continue;
    other_odometry_.emplace_back(&sensor,
                                 n.advertise<nav_msgs::Odometry>(ns + sensor.topic, kQueueLength));
  }
  for (const RotorModel& rotor : model.rotors) {
    rotor_pubs_.push_back(n.advertise<std_msgs::Float32>(
        fmt::format("{}motor_speed/{}", ns, rotor.motor_number), kQueueLength));
  }
}

void VehicleTopics::publish() {
  const Measurement measured = simulator_.measure();
  last_odometry_ = toMsg(simulator_.odometry(*primary_), primary_->frame);
  last_motor_speed_ = toMsg(measured.rotor_speed, simulator_.model(), simulator_.timeNanoseconds(),
                            name_ + "/base_link");
  motor_speed_pub_.publish(last_motor_speed_);
  odometry_pub_.publish(
      last_odometry_);  // after the motor speeds: controllers start on the odometry
  publishOthers(measured);
}

/// What only matters to those who listen.
void VehicleTopics::publishOthers(const Measurement& measured) {
  if (relay_pub_.getNumSubscribers() > 0) {
    mav_msgs::Actuators relay;
    relay.header.stamp = last_odometry_.header.stamp;
    relay.angular_velocities = simulator_.command();
    relay_pub_.publish(relay);
  }
  for (auto& [sensor, publisher] : other_odometry_) {
    if (publisher.getNumSubscribers() > 0)
      publisher.publish(toMsg(simulator_.odometry(*sensor), sensor->frame));
  }
  for (std::size_t i = 0; i < rotor_pubs_.size(); ++i) {
    if (rotor_pubs_[i].getNumSubscribers() == 0) continue;
    const RotorModel& rotor = simulator_.model().rotors[i];
    std_msgs::Float32 joint_speed;  // RotorS publishes the slowed joint's speed here
    joint_speed.data = static_cast<float>(rotor.spin * measured.rotor_speed[i] / rotor.slowdown);
    rotor_pubs_[i].publish(joint_speed);
  }
  if (tf_pub_.getNumSubscribers() == 0) return;
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(toTransform(last_odometry_));
  for (auto& entry : other_odometry_) {
    transforms.transforms.push_back(
        toTransform(toMsg(simulator_.odometry(*entry.first), entry.first->frame)));
  }
  tf_pub_.publish(transforms);
}

}  // namespace quad_sim
