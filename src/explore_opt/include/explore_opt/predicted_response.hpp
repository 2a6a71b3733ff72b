/// The regressors the nominal system would produce, in a form that no longer depends on T.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// Factors F_a with N(a) = (Σ a_a F_a)ᵀ (Σ a_a F_a), the normalised information matrix
/// N = D^{-1/2} (Q [⊗ I]) D^{-1/2} of amplitudes a. The exploration condition is N(a) ⪰ γ_w I.
///
/// The p responses are stacked and replaced by the triangle of one QR, so every product F_aᵀ F_b
/// equals that of the T-long responses, and nothing T-long is left. For D_des = D ⊗ I the n is n_φ
/// (the full matrix only repeats the eigenvalues), otherwise n_φ n_x.
struct PredictedResponse {
  std::vector<Eigen::MatrixXd> factors;  ///< p matrices, r x n, r <= p n

  int numAmplitudes() const { return static_cast<int>(factors.size()); }
  int size() const { return static_cast<int>(factors.front().cols()); }  ///< n

  Eigen::MatrixXd factor(const Eigen::VectorXd& a) const;       ///< Σ a_a F_a
  Eigen::MatrixXd information(const Eigen::VectorXd& a) const;  ///< N(a)
  /// λ_min(N(a)), from singular values of factor(a)
  double lambdaMin(const Eigen::VectorXd& a) const;

  /// H(Z)_ab = tr(Z S_ab), S_ab = (F_aᵀ F_b + F_bᵀ F_a)/2; p x p. @param Z  symmetric, n x n
  Eigen::MatrixXd gramOf(const Eigen::MatrixXd& Z) const;
};

/// Regressors φ_k = [x_k; u_k], n_φ x T, of the nominal system from rest with unit amplitude of
/// component `component` = i n_u + j (carrier i in input j), feedback K included.
Eigen::MatrixXd unitResponse(const ExplorationProblem& problem, int component);

/// @throws quad_support::DataError as validate(problem), or if a response is not finite (unstable
/// A, large T)
PredictedResponse predictResponse(const ExplorationProblem& problem);

/// D_des^{-1/2}, the symmetric root, n x n with n as in PredictedResponse.
Eigen::MatrixXd closenessInverseRoot(const ExplorationProblem& problem);

}  // namespace explore_opt
