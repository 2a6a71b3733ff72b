#include "imu_topic.hpp"

#include "odometry_topics.hpp"
#include "quad_sim_ros/conversions.hpp"

namespace quad_sim {

ImuTopic::ImuTopic(const SensorModel& model, const Simulator& simulator, const std::string& vehicle,
                   ros::NodeHandle& handle)
    : model_(model),
      simulator_(simulator),
      identity_(vehicle + "/" + model.topic),
      frame_(frameOf(model.declaration, model.frame, vehicle)) {
  renew();
  constexpr int kQueueLength = 10;
  publisher_ = handle.advertise<sensor_msgs::Imu>("/" + vehicle + "/" + model.topic, kQueueLength);
}

void ImuTopic::renew() {
  const SimulatorOptions& o = simulator_.options();
  sensor_ =
      std::make_unique<ImuSensor>(model_, identity_, o.seed, o.step, o.allQuirks().sensor_reports);
}

std::int64_t ImuTopic::nextEvent(std::int64_t step) const {
  if (publisher_.getNumSubscribers() == 0) return OdometryTopics::kNever;
  return (step / sensor_->period() + 1) * sensor_->period();
}

void ImuTopic::atEvent(std::int64_t step) {
  if (step % sensor_->period() != 0 || publisher_.getNumSubscribers() == 0) return;
  const ImuReading r = sensor_->sense(simulator_.imu(model_), step);
  sensor_msgs::Imu out;
  out.header.stamp = toStamp(r.time_ns);
  out.header.frame_id = frame_;
  out.orientation.w = r.q_WS.w();
  out.orientation.x = r.q_WS.x();
  out.orientation.y = r.q_WS.y();
  out.orientation.z = r.q_WS.z();
  // The orientation is the true one, which no IMU measures. All zeros: of unknown covariance;
  // RotorS says "not there".
  if (simulator_.options().allQuirks().sensor_reports) out.orientation_covariance.assign(-1.0);
  out.angular_velocity.x = r.rate_S.x();
  out.angular_velocity.y = r.rate_S.y();
  out.angular_velocity.z = r.rate_S.z();
  out.linear_acceleration.x = r.specific_force_S.x();
  out.linear_acceleration.y = r.specific_force_S.y();
  out.linear_acceleration.z = r.specific_force_S.z();
  for (std::size_t i = 0; i < 9; i += 4) {
    out.angular_velocity_covariance[i] = sensor_->rateVariance();
    out.linear_acceleration_covariance[i] = sensor_->forceVariance();
  }
  publisher_.publish(out);
}

}  // namespace quad_sim
