/// What the nominal system does under any given signal, and what that signal must cost.
#pragma once

#include <Eigen/Core>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// The noise-free experiment: states x_0 ... x_T, n_x x (T+1), and inputs u_k = K x_k + e_k,
/// n_u x T.
struct NominalExperiment {
  Eigen::MatrixXd X, U;
};

/// Simulates the nominal system from x0 under a signal. @param signal  e_0 ... e_{T-1}, n_u x T
/// @throws quad_support::DataError: wrong shape, or the states overflow (names the sample)
NominalExperiment simulateNominal(const ExplorationProblem& problem, const Eigen::MatrixXd& signal);

/// Smallest factor s with which s·signal meets the data condition of a design, P_θ⁻¹ ⪰ γ_w D_des on
/// the unknown entries (D_des as in ExplorationProblem), by simulation; infinite if no factor does.
/// For a start away from rest: the smallest beyond which the condition holds throughout, found from
/// above. Several experiments (problem.experiments = r) share the condition: P_θ⁻¹ is then the mean
/// of theirs.
/// @param signal  n_u x T, several experiments side by side: n_u x r T
double requiredScale(const ExplorationProblem& problem, const Eigen::MatrixXd& signal);

/// The factor of least cost among those from requiredScale() on: for a start away from rest and
/// cost on the input a larger signal may leave less input. Else the same number.
double cheapestScale(const ExplorationProblem& problem, const Eigen::MatrixXd& signal);

/// sqrt(2 Σ‖e_k‖²/T): the norm ‖a‖ of a multisine on the grid of the same energy.
double equivalentAmplitude(const Eigen::MatrixXd& signal);

/// sqrt(2 Σ‖u_k‖²/T) of the inputs u_k = K x_k + e_k from x0: what a design with cost on the input
/// minimises. Several experiments: the root mean square. @param signal  as in requiredScale()
double inputAmplitude(const ExplorationProblem& problem, const Eigen::MatrixXd& signal);

}  // namespace explore_opt
