/// Least-squares solutions made as exact as the data: residuals in doubled precision.
#pragma once

#include <Eigen/Core>

namespace explore_opt {

/// Powers of two near the columns' lengths (1 for a column of zeros): dividing by them rounds
/// nothing.
Eigen::VectorXd exactScales(const Eigen::MatrixXd& m);

struct RefinedSolution {
  Eigen::MatrixXd solution;  ///< n x m
  Eigen::MatrixXd residual;  ///< targets - A solution, T x m, correctly rounded
};

/// Corrects a solution of min ‖A X - B‖ by steps RᵀR Δ = Aᵀ(B - A X), the right side in doubled
/// precision (Björck 1996, section 2.9: corrected seminormal equations). A QR alone loses κ² ε of a
/// solution with a large residual; each step here gains a factor κ² ε, until X is exact to rounding
/// (κ up to about 1e7). A step that does not shrink is not taken.
/// @param A  T x n   @param B  T x m   @param R  n x n, upper triangular, RᵀR = AᵀA up to rounding
RefinedSolution refine(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& R,
                       const Eigen::MatrixXd& solution);

}  // namespace explore_opt
