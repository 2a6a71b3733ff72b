/// What a flight's data say about the model, and whether the promise was kept.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "explore_opt/initial_estimate.hpp"
#include "explore_opt/set_membership.hpp"
#include "quad_experiment/trajectory.hpp"

namespace quad_experiment {

/// What is known of the experiment before it is flown; the truth only because this is a simulation.
struct Knowledge {
  explore_opt::AltitudeParameters truth;     ///< dT [s], m [kg], nominal and unrounded
  explore_opt::AltitudeParameters estimate;  ///< dT_hat [s], m_hat [kg]
  double gravity = 0.0;                      ///< [m/s^2]
  int num_samples = 0;                       ///< T
  double gamma_w = 0.0;                      ///< assumed bound, Eq. (1.6)
  double desired_closeness = 0.0;            ///< lambda of D_des

  double feedforward() const { return estimate.mass * gravity; }  ///< m_hat g [N]
};

/// The starting point: thesis section 2.4.1.
struct InitialVerdict {
  double error_norm = 0.0;           ///< ||e|| over A12, B1, B2
  double lambda_D0 = 0.0;            ///< 1/||vec(Theta_tr - Theta_0)||^2
  double gamma_w_true = 0.0;         ///< energy of gravity without feed-forward
  double gamma_w_compensated = 0.0;  ///< energy left with feed-forward m_hat g, Eq. (2.3)
  bool asks_for_more = false;        ///< D_des >= D_init
};

InitialVerdict judgeStart(const Knowledge& knowledge);

/// Everything computed from the data of one flight; design.md's definitions.
struct FlightVerdict {
  explore_opt::LeastSquaresFit fit;
  std::optional<explore_opt::FeasibleSet> set;  ///< none if the data are not exciting
  double dT_hat = 0.0, m_hat = 0.0;             ///< A12 [s], A12/B2 [kg] of the fit
  double error_norm = 0.0;                      ///< ||e|| over A12, B1, B2
  double lambda_D_exp = 0.0, objective = 0.0;   ///< over all six entries, Eq. (1.9)
  double signal_energy = 0.0;                   ///< sum of T_eff,cmd^2 [N^2]
  double gamma_w_exp = 0.0, gamma_w_sim = 0.0;  ///< Eq. (3.1) and below
  double gamma_w_pilot_literal = 0.0;   ///< Eq. (1.12), simulated from x_0 with the initial model
  double gamma_w_pilot_one_step = 0.0;  ///< Eq. (1.12), one step ahead of the measured state
  explore_opt::ClosenessChain chain;
  bool truth_in_set = false, gamma_w_valid = false, gamma_w_falsified = false;
  bool exploration_condition = false, objective_met = false;
  double max_tilt = 0.0;           ///< [rad] over the whole flight, Assumption 1
  double max_lateral_speed = 0.0;  ///< [m/s] over the whole flight, Assumptions 1 and 2
  double min_altitude = 0.0;       ///< [m]
  int clamped_commands = 0;        ///< rotor commands that had to be clamped

  /// The promise: condition met, objective met, gamma_w not falsified.
  bool ok() const { return exploration_condition && objective_met && !gamma_w_falsified; }
};

/// @param data  of the exploration phase   @param trajectory  the whole flight
FlightVerdict judgeFlight(const Knowledge& knowledge, const ExplorationData& data,
                          const Trajectory& trajectory);

/// Lengths of a flight's intervals.
struct TimeVerdict {
  double mean = 0.0, std = 0.0, max_abs_error = 0.0;  ///< [s]
};
TimeVerdict judgeTime(const Trajectory& trajectory, double sampling_period);

/// Service delays x^noise of a flight on the wall clock.
struct DelayVerdict {
  double mean = 0.0, std = 0.0;  ///< [s]
  double estimated = 0.0;        ///< x^ after the last interval [s]
  int without_wait = 0;          ///< intervals in which the delay alone took dT or more
};
/// @returns none without timings
std::optional<DelayVerdict> judgeDelay(const std::vector<IntervalTiming>& timing);

}  // namespace quad_experiment
