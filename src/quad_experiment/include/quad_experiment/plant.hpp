/// What the experiment loop may ask of a vehicle, simulated here, behind ROS, or real.
#pragma once

#include <string>
#include <vector>

#include "quad_control/flight_controller.hpp"
#include "quad_experiment/middleware.hpp"
#include "quad_sim/state.hpp"

namespace quad_experiment {

/// How an interval paced by the clock on the wall came about, thesis section 1.2.4. All in seconds.
struct IntervalTiming {
  double wait = 0.0;             ///< dT_ctrl: from unpausing to pausing
  double service_delay = 0.0;    ///< x^noise = dT_sim - dT_ctrl
  double estimated_delay = 0.0;  ///< x^ after this interval, the forgetting-factor mean of x^noise
};

/// The three things one can ask of a plant. Its controller is part of it: the loop sees
/// measurements only.
class Plant {
 public:
  virtual ~Plant() = default;
  /// Puts the vehicle into its start state and hands over references and the whole exploration
  /// signal.
  /// @returns the state at time zero
  virtual quad_sim::Measurement begin(const quad_control::FlightPlan& plan) = 0;
  /// Flies one control interval. @returns state and rotor speeds at its end
  virtual quad_sim::Measurement advance(const Interval& interval) = 0;
  /// Ends the flight. @returns the commands computed since begin(), each with the time of the state
  /// it answers
  virtual std::vector<quad_control::ControlOutput> end() = 0;
  /// One entry an interval since begin(), if the clock on the wall paced them; empty where
  /// simulated time is exact.
  virtual std::vector<IntervalTiming> timing() const { return {}; }
};

}  // namespace quad_experiment
