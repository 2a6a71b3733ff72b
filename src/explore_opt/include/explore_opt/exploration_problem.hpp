/// What an exploration experiment is asked to achieve, in matrices.
#pragma once

#include <Eigen/Core>

#include "explore_opt/exploration_signal.hpp"

namespace explore_opt {

/// Find amplitudes of least norm whose predicted data satisfy P_θ⁻¹ ⪰ γ_w D_des; Eqs. (1.10) and
/// (1.13).
struct ExplorationProblem {
  Eigen::MatrixXd A;          ///< nominal system, n_x x n_x
  Eigen::MatrixXd B;          ///< n_x x n_u
  SpectralLines lines;        ///< T and the lines
  Phase phase = Phase::kCos;  ///< of the carriers
  double gamma_w = 0.0;       ///< bound on the disturbance's energy, Eq. (1.6); > 0
  Eigen::MatrixXd
      D_des;  ///< positive definite: 1 x 1 (λ I), n_φ x n_φ (D ⊗ I) or n_φ n_x x n_φ n_x
  Eigen::VectorXd
      x0;  ///< start relative to the experiment's origin, n_x; empty or zero (only zero is solved)
  Eigen::MatrixXd K;  ///< n_u x n_x: the input is u = K x + signal; empty means no feedback

  int numStates() const { return static_cast<int>(A.rows()); }
  int numInputs() const { return static_cast<int>(B.cols()); }
  int numRegressors() const { return numStates() + numInputs(); }
  /// Number p of decision variables; component i n_u + j is the amplitude of carrier i in input j.
  int numAmplitudes() const { return numCarriers(lines, phase) * numInputs(); }
};

/// @throws quad_support::DataError naming the field, its value and what it must be: shapes, values
/// that are not finite, γ_w <= 0, lines (see validate(SpectralLines)), D_des not symmetric or not
/// positive definite, x0 not zero
void validate(const ExplorationProblem& problem);

}  // namespace explore_opt
