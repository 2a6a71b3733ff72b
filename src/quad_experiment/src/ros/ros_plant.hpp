/// The plant behind ROS: simulator, controller and time-manager nodes do the work, this only asks.
#pragma once

#include <ros/ros.h>

#include <chrono>
#include <string>

#include "answer_limit.hpp"
#include "quad_experiment/plant.hpp"

namespace quad_experiment {

struct RosPlantOptions {
  std::string time_manager;  ///< name of the time-manager node
  std::string controller;    ///< name of the controller node
  std::string mode;          ///< lockstep or wallclock: what the time manager has to say of itself
  double timeout = 3.0;      ///< [s] wall time the controller may take for a command
  double rate = 0.0;  ///< simulated seconds per second of wall time at most; 0: as fast as possible
};

/// Every value it returns comes from a service's answer; topics may lose messages, answers do not.
/// All functions throw quad_support::EnvironmentError naming the service when a node is lost or
/// refuses.
class RosPlant : public Plant {
 public:
  /// Waits for the nodes' services. @param start_timeout  [s] wall time
  RosPlant(ros::NodeHandle& node, const RosPlantOptions& options, double start_timeout);

  quad_sim::Measurement begin(const quad_control::FlightPlan& plan) override;
  quad_sim::Measurement advance(const Interval& interval) override;
  std::vector<quad_control::ControlOutput> end() override;
  std::vector<IntervalTiming> timing() const override { return timing_; }

 private:
  template <class Service>
  void ask(ros::ServiceClient& client, Service& service);
  void pace(std::int64_t time_ns);

  RosPlantOptions options_;
  AnswerLimit answers_;
  ros::ServiceClient set_flight_plan_, flight_record_, begin_, advance_, end_;
  std::chrono::steady_clock::time_point started_;
  std::vector<IntervalTiming> timing_;
};

}  // namespace quad_experiment
