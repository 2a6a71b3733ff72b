/// One flight: hold, then exploration, over any plant.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "quad_control/flight_controller.hpp"
#include "quad_experiment/middleware.hpp"
#include "quad_experiment/plant.hpp"
#include "quad_experiment/trajectory.hpp"
#include "quad_support/errors.hpp"

namespace quad_experiment {

/// The vehicle touched the ground where there was to be none.
class GroundContact : public quad_support::SimulationError {
 public:
  using quad_support::SimulationError::SimulationError;
};

/// What a flight needs besides the plant.
struct FlightSpec {
  quad_control::FlightPlan plan;  ///< references, feed-forward, signal and its start time
  double end_of_hold = 0.0;       ///< [s] length of a flight without exploration; unused otherwise
};

/// Called after each interval with the state at its end; for progress.
using FlightProgress = std::function<void(const quad_sim::Odometry&)>;

/// Thesis section 1.2.4, steps (a) to (j), until the signal of the plan has been flown (T inputs, T
/// + 1 states) or, without a signal, until `end_of_hold`.
/// @throws quad_support::SimulationError: ground contact at any time, between samples too
/// (GroundContact), a state that is not finite, a vehicle on its back;
///         quad_support::EnvironmentError: the plant is lost; quad_support::Interrupted
Trajectory fly(Plant& plant, const FlightSpec& spec, const Middleware& middleware,
               const FlightProgress& progress = {});

}  // namespace quad_experiment
