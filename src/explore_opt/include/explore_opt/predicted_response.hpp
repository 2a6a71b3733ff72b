/// The regressors the nominal system would produce, in a form that no longer depends on T.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// Factors with N(a) = F(a)ᵀ F(a), F(a) = F_0 + Σ a_a F_a, the normalised information matrix
/// N = W Eᵀ(Q ⊗ I)E W of amplitudes a, W = D^{-1/2}, E the columns of unknown entries. The
/// exploration condition is N(a) ⪰ γ_w I. F_0 is the response to x_0, math.md 2.2.
///
/// The T-long responses are replaced by a triangle with the same products of columns (see
/// response_root.hpp), so nothing T-long is left. For D_des = D ⊗ I the n is n_φ (the full matrix
/// only repeats the eigenvalues; with known entries one block for each set of unknown regressors),
/// otherwise the number of unknown entries.
struct PredictedResponse {
  std::vector<Eigen::MatrixXd> factors;  ///< p matrices, r x n
  Eigen::MatrixXd offset;                ///< F_0, r x n; empty if x_0 = 0

  int numAmplitudes() const { return static_cast<int>(factors.size()); }
  int size() const { return static_cast<int>(factors.front().cols()); }  ///< n
  bool homogeneous() const { return offset.size() == 0; }

  Eigen::MatrixXd factor(const Eigen::VectorXd& a) const;       ///< F(a)
  Eigen::MatrixXd information(const Eigen::VectorXd& a) const;  ///< N(a)
  /// λ_min(N(a)), from singular values of factor(a)
  double lambdaMin(const Eigen::VectorXd& a) const;
};

/// Regressors φ_k = [x_k; u_k], n_φ x T, of the nominal system from rest with unit amplitude of
/// component `component` = i n_u + j (carrier i in input j), feedback K included.
Eigen::MatrixXd unitResponse(const ExplorationProblem& problem, int component);

/// Inputs u_k = K x_k + signal of the nominal system from x_0, n_u x T.
/// @param amplitudes  carriers x n_u
Eigen::MatrixXd predictedInputs(const ExplorationProblem& problem,
                                const Eigen::MatrixXd& amplitudes);

/// @throws quad_support::DataError as validate(problem); ResponseOverflow if a response grows
/// beyond what doubles resolve (unstable A, large T)
PredictedResponse predictResponse(const ExplorationProblem& problem);

/// W: D_des^{-1/2}, the symmetric root, of the unknown entries; n x n with n as in
/// PredictedResponse.
Eigen::MatrixXd closenessInverseRoot(const ExplorationProblem& problem);

}  // namespace explore_opt
