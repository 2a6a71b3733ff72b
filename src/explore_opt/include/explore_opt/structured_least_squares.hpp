/// Least squares with some entries of Θ = [A B] known: they are kept, the others estimated.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore_opt/least_squares.hpp"

namespace explore_opt {

/// Position of an entry of Θ, from 0.
struct Entry {
  int row = 0, column = 0;
};

/// θ = c + E ϑ: what the data say about the free entries ϑ. As LeastSquaresFit where names agree.
struct StructuredFit {
  bool exciting = false;
  double condition = 0.0;
  Eigen::VectorXd singular_values;
  std::vector<Entry> free;      ///< where ϑ stands in Θ, columns of Θ one after the other
  Eigen::MatrixXd Theta;        ///< known and estimated entries, n_x x n_φ
  Eigen::MatrixXd root;         ///< R with RᵀR = information, upper triangular
  Eigen::MatrixXd information;  ///< P_ϑ⁻¹ = Eᵀ (S ⊗ I) E
  double residual_energy = 0.0;
};

/// Sparse QR of (φ_kᵀ ⊗ I) E, columns scaled to length one.
/// @param X      states x_0 ... x_T, n_x x (T+1)      @param U  inputs u_0 ... u_{T-1}, n_u x T
/// @param known  [A B], n_x x n_φ, NaN where the entry is to be estimated
/// @throws quad_support::DataError: shapes that do not fit, values that are not finite, nothing to
/// estimate, fewer equations than unknowns
StructuredFit fitStructured(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U,
                            const Eigen::MatrixXd& known);

/// The same for data that need not excite, any T >= 1, row by row of Θ; as openFit() is to
/// fitLeastSquares().
/// @throws quad_support::DataError: shapes that do not fit, values that are not finite, nothing to
/// estimate
StructuredFit openStructuredFit(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U,
                                const Eigen::MatrixXd& known);

/// D restricted to the free entries, Eᵀ D E. @param closeness  as fullCloseness() in
/// set_membership.hpp
Eigen::MatrixXd restrictCloseness(const Eigen::MatrixXd& closeness, const StructuredFit& fit);

}  // namespace explore_opt
