/// The plant in this process: simulator and controller as objects.
#pragma once

#include "quad_control/flight_controller.hpp"
#include "quad_experiment/experiment_config.hpp"
#include "quad_experiment/plant.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_experiment {

/// Does what the ROS nodes do, in the same order, so that both give the same bits.
class InProcessPlant : public Plant {
 public:
  /// @throws quad_support::ConfigError if the vehicle cannot be simulated or controlled
  explicit InProcessPlant(const ExperimentConfig& config);

  quad_sim::Measurement begin(const quad_control::FlightPlan& plan) override;
  quad_sim::Measurement advance(const Interval& interval) override;
  std::vector<quad_control::ControlOutput> end() override;

 private:
  quad_sim::Simulator simulator_;
  quad_control::FlightController controller_;
  quad_sim::Measurement now_;
};

}  // namespace quad_experiment
