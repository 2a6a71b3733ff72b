/// What an exploration experiment is asked to achieve, in matrices.
#pragma once

#include <Eigen/Core>
#include <string>

#include "explore_opt/exploration_signal.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

/// What is to be small: the amplitudes of the signal, γ_e = ‖a‖, or the true input K x + signal,
/// γ_e = sqrt((2/T) Σ_k ‖u_k‖²), which on the grid and without K is the same number.
enum class CostOn { kSignal, kInput };

std::string toString(CostOn cost);  ///< "signal", "input"
/// @throws quad_support::DataError naming the choices
CostOn costFromString(const std::string& text);

/// Find amplitudes of least norm whose predicted data satisfy P_θ⁻¹ ⪰ γ_w D_des; Eqs. (1.10) and
/// (1.13).
struct ExplorationProblem {
  Eigen::MatrixXd A;          ///< nominal system, n_x x n_x
  Eigen::MatrixXd B;          ///< n_x x n_u
  SpectralLines lines;        ///< T and the lines
  Phase phase = Phase::kCos;  ///< of the carriers
  double gamma_w = 0.0;       ///< bound on the disturbance's energy, Eq. (1.6); > 0
  /// 1 x 1 (λ I), n_φ x n_φ (D ⊗ I) or n_φ n_x x n_φ n_x; positive semidefinite, not zero. Where it
  /// is singular, 1e-6 of its largest eigenvalue is asked for, so that the data determine
  /// everything.
  Eigen::MatrixXd D_des;
  Eigen::VectorXd x0;  ///< start relative to the experiment's origin, n_x; empty means zero
  Eigen::MatrixXd K;   ///< n_u x n_x: the input is u = K x + signal; empty means no feedback
  CostOn cost = CostOn::kSignal;
  /// n_x x n_φ: entries of [A B] that need not be learnt, NaN where unknown; empty: none is known
  Eigen::MatrixXd known;
  /// Limits of the predicted input for all k: empty (none), 1 (on ‖u_k‖) or n_u (on each input)
  Eigen::VectorXd u_max;
  /// Runs r with amplitudes of their own; γ_e is their root mean square, the noise of r runs adds
  int experiments = 1;

  int numStates() const { return static_cast<int>(A.rows()); }
  int numInputs() const { return static_cast<int>(B.cols()); }
  int numRegressors() const { return numStates() + numInputs(); }
  /// Number p of decision variables; component i n_u + j is the amplitude of carrier i in input j.
  int numAmplitudes() const { return numCarriers(lines, phase) * numInputs(); }
  /// What the states follow between the signal's samples: A, or A + B K.
  Eigen::MatrixXd dynamics() const { return K.size() > 0 ? Eigen::MatrixXd(A + B * K) : A; }
};

/// @throws quad_support::DataError naming the field, its value and what it must be: shapes, values
/// that are not finite, γ_w <= 0, lines (see validate(SpectralLines)), D_des not symmetric,
/// indefinite or zero, known entries that differ from A and B, sizes no solver here can hold
void validate(const ExplorationProblem& problem);

/// The response of the nominal system cannot be held in double precision: a negative answer, not a
/// mistake in the problem.
class ResponseOverflow : public quad_support::DataError {
 public:
  using quad_support::DataError::DataError;
};

}  // namespace explore_opt
