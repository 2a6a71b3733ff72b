#include "odometry_topics.hpp"

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <algorithm>

#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

std::string frameOf(const PluginDeclaration& plugin, const std::string& frame,
                    const std::string& vehicle) {
  const std::string made_for = plugin.text("robotNamespace", "");
  if (made_for.empty() || frame.rfind(made_for + "/", 0) != 0) return frame;
  return vehicle + frame.substr(made_for.size());
}

OdometryTopics::OdometryTopics(const SensorModel& model, const Simulator& simulator,
                               const std::string& vehicle, ros::NodeHandle& handle, bool primary)
    : model_(model),
      simulator_(simulator),
      identity_(vehicle + "/" + model.topic),
      frame_(frameOf(model.declaration, model.frame, vehicle)),
      primary_(primary) {
  constexpr int kQueueLength = 10;
  renew();
  const std::string ns = "/" + vehicle + "/";
  const auto slash = model.topic.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : model.topic.substr(0, slash + 1);
  const auto name = [&](const char* tag, const char* usual) {
    return ns + model.declaration.text(tag, folder + usual);
  };
  odometry_ = handle.advertise<nav_msgs::Odometry>(ns + model.topic, kQueueLength, primary);
  pose_ = handle.advertise<geometry_msgs::Pose>(name("poseTopic", "pose"), kQueueLength);
  pose_with_covariance_ = handle.advertise<geometry_msgs::PoseWithCovarianceStamped>(
      name("poseWithCovarianceTopic", "pose_with_covariance"), kQueueLength);
  position_ = handle.advertise<geometry_msgs::PointStamped>(name("positionTopic", "position"),
                                                            kQueueLength);
  transform_ = handle.advertise<geometry_msgs::TransformStamped>(
      name("transformTopic", "transform"), kQueueLength);
}

void OdometryTopics::renew() {
  const SimulatorOptions& o = simulator_.options();
  sensor_ = std::make_unique<OdometrySensor>(model_, identity_, o.seed, o.step,
                                             o.allQuirks().sensor_reports);
  delay_ = std::make_unique<OdometryDelay>(*sensor_);
  last_ = nav_msgs::Odometry();
}

bool OdometryTopics::wanted() const {
  if (primary_) return true;
  const std::array<const ros::Publisher*, 5> all = {&odometry_, &pose_, &pose_with_covariance_,
                                                    &position_, &transform_};
  return std::any_of(all.begin(), all.end(),
                     [](const ros::Publisher* p) { return p->getNumSubscribers() > 0; });
}

std::int64_t OdometryTopics::nextEvent(std::int64_t step) const {
  return sensor_->scheduled() && wanted() ? delay_->nextEvent(step) : kNever;
}

void OdometryTopics::atEvent(std::int64_t step, const ros::Publisher& tf) {
  if (!sensor_->scheduled() || !wanted()) return;
  const auto reading = delay_->at(step, simulator_.odometry(model_));
  if (!reading) return;
  send(*reading);
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(toTransform(last_));
  if (tf.getNumSubscribers() > 0) tf.publish(transforms);
}

void OdometryTopics::publish(bool tf_wanted, tf2_msgs::TFMessage& transforms) {
  if (sensor_->scheduled() || (!tf_wanted && !wanted())) return;
  send(sensor_->sense(simulator_.odometry(model_), simulator_.stepCount()));
  transforms.transforms.push_back(toTransform(last_));
}

void OdometryTopics::send(const Odometry& reading) {
  Odometry stamped = reading;
  stamped.time_ns += sensor_->extraStamp();
  last_ = toMsg(stamped, frame_);
  for (std::size_t i = 0; i < 6; ++i) {
    last_.pose.covariance[7 * i] = sensor_->poseVariance()[i];
    last_.twist.covariance[7 * i] = sensor_->twistVariance()[i];
  }
  if (primary_ || odometry_.getNumSubscribers() > 0) odometry_.publish(last_);
  if (pose_.getNumSubscribers() > 0) pose_.publish(last_.pose.pose);
  if (pose_with_covariance_.getNumSubscribers() > 0) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.header = last_.header;
    pose.pose = last_.pose;
    pose_with_covariance_.publish(pose);
  }
  if (position_.getNumSubscribers() > 0) {
    geometry_msgs::PointStamped position;
    position.header = last_.header;
    position.point = last_.pose.pose.position;
    position_.publish(position);
  }
  if (transform_.getNumSubscribers() > 0) transform_.publish(toTransform(last_));
}

}  // namespace quad_sim
