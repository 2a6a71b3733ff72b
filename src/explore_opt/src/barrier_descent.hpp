/// The design problem itself, not a relaxation, by a log-det barrier: the local solver for
/// conditions too large for the factor program.
#pragma once

#include "quadratic_program.hpp"

namespace explore_opt {

struct BarrierPoint {
  Eigen::VectorXd a;   ///< strictly feasible; empty if the start is not
  Eigen::MatrixXd Z;   ///< μ S⁻¹, S = N(a) - R, of a centre at up to 25 times `gap`
  Eigen::VectorXd nu;  ///< one a peak limit
};

/// Follows the minimisers of  ½‖a‖² - μ log det S(a) - ½ μ Σ log room_k(a)  down to n μ = `gap` of
/// ½‖a‖², from a strictly feasible start of norm about one. Only p unknowns, whatever n: Newton's
/// steps, with the moduli of the Hessian's eigenvalues where it is indefinite
/// (I + μ tr(W S_i W S_j) - 2 μ H(W), math.md 4), and Armijo's rule.
BarrierPoint descendBarrier(const QuadraticProgram& program, const Eigen::VectorXd& start,
                            double gap);

}  // namespace explore_opt
