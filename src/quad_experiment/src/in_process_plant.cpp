#include "quad_experiment/in_process_plant.hpp"

#include "quad_sim/simulation_config.hpp"

namespace quad_experiment {

InProcessPlant::InProcessPlant(const ExperimentConfig& config)
    : simulator_(quad_sim::makeSimulator(config.simulation, config.vehicle())),
      controller_(config.vehicle(), config.control) {}

quad_sim::Measurement InProcessPlant::begin(const quad_control::FlightPlan& plan) {
  controller_.begin(plan);
  simulator_.reset();
  simulator_.measure(now_);
  return now_;
}

quad_sim::Measurement InProcessPlant::advance(const Interval& interval) {
  const quad_control::ControlOutput& command = controller_.update(now_.odometry);
  simulator_.advance(interval.hold_steps);  // the latency: the command before is still in force
  simulator_.setCommand(command.rotor_speed);
  simulator_.advance(interval.steps - interval.hold_steps);
  simulator_.measure(now_);
  return now_;
}

std::vector<quad_control::ControlOutput> InProcessPlant::end() { return controller_.record(); }

}  // namespace quad_experiment
