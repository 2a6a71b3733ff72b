/// What one vehicle says over ROS.
#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <mav_msgs/Actuators.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <rotors_comm/WindSpeed.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "imu_topic.hpp"
#include "odometry_topics.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {

/// Publishes a simulator's present state on the topics below the vehicle's namespace.
class VehicleTopics {
 public:
  /// @param name  the vehicle's namespace, without slashes at its ends
  /// @throws std::invalid_argument if the vehicle has no odometry sensor, quad_support::ConfigError
  /// for a sensor's tags
  VehicleTopics(const Simulator& simulator, const std::string& name, ros::NodeHandle& handle);

  void start();                    ///< after a reset: forgets samples on their way, senses step 0
  void renew();                    ///< after a change of the physics step
  std::int64_t nextEvent() const;  ///< step of the next instant of a sensor of its own
  void atEvent();                  ///< to be called there
  void publish();                  ///< everything else, now
  void archive(StateArchive& archive);
  const std::vector<double>& jointAngles() const {
    return angle_;
  }  ///< of the latest publish() [rad], by motor number

  const nav_msgs::Odometry& odometry() const {
    return odometry_.front()->last();
  }  ///< of the primary sensor
  const mav_msgs::Actuators& motorSpeed() const {
    return last_motor_speed_;
  }  ///< of the latest publish()

 private:
  void publishRotors(const std::vector<double>& speed);
  void publishHeld();
  void turnRotors(const std::vector<double>& speed);

  const Simulator& simulator_;
  std::string name_;
  std::string force_frame_;  ///< as the wind plugin calls the world
  std::vector<std::unique_ptr<OdometryTopics>>
      odometry_;  ///< the first is the one controllers listen to
  std::vector<std::unique_ptr<ImuTopic>> imus_;
  mav_msgs::Actuators last_motor_speed_;
  std::vector<double> angle_, speed_before_;  ///< of the rotors, for joint_states [rad, rad/s]
  std::int64_t turned_ns_ = 0;                ///< to when `angle_` is
  ros::Publisher motor_speed_pub_, relay_pub_, tf_pub_, joints_pub_, wind_pub_, force_pub_;
  std::vector<ros::Publisher> rotor_pubs_;
};

/// The model's wind plugin; nullptr if it has none.
const PluginDeclaration* windPlugin(const VehicleModel& model);
/// All winds together, and the wind plugin's force on the vehicle, as of now.
rotors_comm::WindSpeed windMessage(const Simulator& simulator);
geometry_msgs::WrenchStamped forceMessage(const Simulator& simulator, const std::string& frame);
std::string forceFrame(const VehicleModel& model,
                       const std::string& vehicle);  ///< as the wind plugin names it
/// What the wind plugin calls the topic of the wind, in and out, below the vehicle's namespace.
std::string windSpeedTopic(const VehicleModel& model);

}  // namespace quad_sim
