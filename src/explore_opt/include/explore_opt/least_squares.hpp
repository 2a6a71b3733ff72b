/// Least-squares estimate of a linear system from its states and inputs.
#pragma once

#include <Eigen/Core>

namespace explore_opt {

/// What a fit of x_{k+1} = Θ φ_k says. If `exciting` is false the estimate is not determined by the
/// data: Theta, residual and residual_energy are then empty or zero, the singular values tell why.
/// Other data may determine what these leave open: see openFit().
struct LeastSquaresFit {
  bool exciting = false;            ///< condition <= 1e10
  double condition = 0.0;           ///< of the regressor with its columns scaled to length one
  Eigen::VectorXd singular_values;  ///< of that scaled regressor, largest first
  int num_samples = 0;              ///< T
  Eigen::MatrixXd Theta;            ///< Θ̂ = [A B], n_x x n_φ
  Eigen::MatrixXd root;             ///< R with RᵀR = S, n_φ x n_φ, upper triangular
  Eigen::MatrixXd information;      ///< S = ΦΦᵀ, n_φ x n_φ; P_θ⁻¹ = S ⊗ I
  Eigen::MatrixXd residual;         ///< x_{k+1} - Θ̂ φ_k, n_x x T
  double residual_energy = 0.0;     ///< ‖residual‖²_F

  int numStates() const { return static_cast<int>(Theta.rows()); }
};

/// Fits Θ = [A B] by Householder QR of the column-scaled Φᵀ, φ_k = [x_k; u_k]; thesis
/// sections 1.3.1 and 2.4.4.
/// @param X  states x_0 ... x_T,     n_x x (T+1)
/// @param U  inputs u_0 ... u_{T-1}, n_u x T
/// @throws quad_support::DataError: shapes that do not fit, a value that is not finite, T < n_φ =
/// n_x + n_u
LeastSquaresFit fitLeastSquares(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U);

/// The same for data that need not excite, any T >= 1: of all minimisers the smallest in the scaled
/// regressor's coordinates. Only `root` (of rank below n_φ, then) and `residual_energy` are facts,
/// and Θ̂ in the directions the data excite; all else is for fusion with other data.
LeastSquaresFit openFit(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U);

}  // namespace explore_opt
