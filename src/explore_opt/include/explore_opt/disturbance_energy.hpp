/// Energies of disturbances, Eq. (1.6): known beforehand, from a pilot run, and after the
/// experiment.
#pragma once

#include <Eigen/Core>

#include "explore_opt/linear_system.hpp"

namespace explore_opt {

/// Σ_k ‖W‖² = T ‖W‖² of a constant disturbance, Eq. (1.6). Thesis section 2.4.1 prints 356.23 for
/// gravity alone (356.2361 unrounded). @throws quad_support::DataError if T < 1 or W is not finite
double constantDisturbanceEnergy(const Eigen::VectorXd& W, int num_samples);

/// What is left of W when the input carries a constant feed-forward: W̃ = B u_ff + W, above Eq.
/// (2.3).
/// @param system  discrete   @param feedforward  u_ff, n_u
Eigen::VectorXd compensatedDisturbance(const LinearSystem& system,
                                       const Eigen::VectorXd& feedforward);

/// Eq. (3.1): Σ_k ‖x_{k+1} - A x_k - B u_k - W‖², one step ahead of the measured state. With the
/// true system and W = 0 it is γ_w,exp, with gravity in W and the whole thrust in u it is γ_w,sim.
/// With the nominal system it is the second reading of the pilot run of Eq. (1.12).
/// @param X  n_x x (T+1)   @param U  n_u x T   @throws quad_support::DataError for wrong shapes
double oneStepEnergy(const LinearSystem& system, const Eigen::MatrixXd& X,
                     const Eigen::MatrixXd& U);

/// Eq. (1.12) taken literally: Σ_k ‖x_{k+1} - x̂_{k+1}‖² with x̂_{k+1} = A x̂_k + B u_k + W simulated
/// from x̂_0 = x_0 without measurements. For a double integrator the mismatch is integrated twice,
/// and the energy is absurdly much; oneStepEnergy() of the same data is the reading that can be
/// used.
/// @param X  n_x x (T+1)   @param U  n_u x T   @throws quad_support::DataError for wrong shapes
double simulationEnergy(const LinearSystem& system, const Eigen::MatrixXd& X,
                        const Eigen::MatrixXd& U);

}  // namespace explore_opt
