/// The topics of one odometry sensor: odometry and its four siblings, as RotorS's plugin names
/// them.
#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "quad_sim/odometry_sensor.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {

/// Reads one odometry sensor and publishes the readings.
///
/// An ordinary sensor reads whenever publish() is called. A scheduled one (divisor, delay, update
/// rate) has instants of its own, and atEvent() must be called at each.
class OdometryTopics {
 public:
  /// @param vehicle  namespace, without slashes at its ends
  /// @param primary  the one controllers listen to: is always read, and its odometry latched
  OdometryTopics(const SensorModel& model, const Simulator& simulator, const std::string& vehicle,
                 ros::NodeHandle& handle, bool primary);

  void renew();  ///< for a physics step of another length; forgets samples on their way
  std::int64_t nextEvent(
      std::int64_t step) const;  ///< after `step`; kNever if it has none or nobody listens
  void atEvent(std::int64_t step, const ros::Publisher& tf);
  /// Nothing if scheduled, or if neither its topics nor /tf are listened to.
  void publish(bool tf_wanted, tf2_msgs::TFMessage& transforms);
  const nav_msgs::Odometry& last() const { return last_; }
  void archive(StateArchive& archive) { delay_->archive(archive); }

  static constexpr std::int64_t kNever = std::int64_t{1} << 62;

 private:
  bool wanted() const;
  void send(const Odometry& reading);

  SensorModel model_;  ///< a copy: the simulator makes its own anew when the physics step changes
  const Simulator& simulator_;
  std::string identity_, frame_;
  bool primary_;
  std::unique_ptr<OdometrySensor> sensor_;
  std::unique_ptr<OdometryDelay> delay_;
  nav_msgs::Odometry last_;
  ros::Publisher odometry_;
  ros::Publisher pose_, pose_with_covariance_, position_, transform_;
};

/// The frame "hummingbird/base_link" of a plugin made for the namespace hummingbird, flown as bee2:
/// "bee2/base_link".
std::string frameOf(const PluginDeclaration& plugin, const std::string& frame,
                    const std::string& vehicle);

}  // namespace quad_sim
