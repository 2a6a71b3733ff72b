/// What the experiment loop may ask of a vehicle, simulated here, behind ROS, or real.
#pragma once

#include <string>
#include <vector>

#include "quad_control/flight_controller.hpp"
#include "quad_experiment/middleware.hpp"
#include "quad_sim/state.hpp"

namespace quad_experiment {

/// The three things one can ask of a plant. Its controller is part of it: the loop sees measurements only.
class Plant {
 public:
  virtual ~Plant() = default;
  /// Puts the vehicle into its start state and hands over references and the whole exploration signal.
  /// @returns the state at time zero
  virtual quad_sim::Measurement begin(const quad_control::FlightPlan& plan) = 0;
  /// Flies one control interval. @returns state and rotor speeds at its end
  virtual quad_sim::Measurement advance(const Interval& interval) = 0;
  /// Ends the flight. @returns the commands computed since begin(), each with the time of the state it answers
  virtual std::vector<quad_control::ControlOutput> end() = 0;
};

}  // namespace quad_experiment
