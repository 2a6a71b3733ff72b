/// The topic of one IMU.
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/Imu.h>

#include <cstdint>
#include <memory>
#include <string>

#include "quad_sim/imu_sensor.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {

/// Publishes an IMU's readings at its own instants, while somebody listens.
class ImuTopic {
 public:
  ImuTopic(const SensorModel& model, const Simulator& simulator, const std::string& vehicle,
           ros::NodeHandle& handle);

  void renew();  ///< for a physics step of another length
  std::int64_t nextEvent(
      std::int64_t step) const;  ///< after `step`; OdometryTopics::kNever if nobody listens
  void atEvent(std::int64_t step);

 private:
  SensorModel model_;  ///< a copy, as in OdometryTopics
  const Simulator& simulator_;
  std::string identity_, frame_;
  std::unique_ptr<ImuSensor> sensor_;
  ros::Publisher publisher_;
};

}  // namespace quad_sim
