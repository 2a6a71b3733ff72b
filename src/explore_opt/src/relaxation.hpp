/// The design problem with a aᵀ relaxed to a matrix: a certified lower bound, and where to look for
/// the amplitudes.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "lmi_solver.hpp"
#include "quadratic_program.hpp"

namespace explore_opt {

/// Solution of the pair (math.md 6; without x_0 and peak limits s and ν are absent)
///
///   max tr(RZ) + s - ½ Σ ν_k   s.t.  Z ⪰ 0, ν >= 0,  blkdiag(I, -2s) - 2 H(Z) + Σ ν_k Q_kᵀQ_k ⪰ 0
///   min ½ tr 𝒜                 s.t.  𝒜 ⪰ 0, 𝒜_00 = 1, Σ 𝒜_ab S_ab ⪰ R, tr(Q_kᵀQ_k 𝒜) <= 1
struct RelaxedSolution {
  Eigen::MatrixXd Z;       ///< n x n, ⪰ 0
  Eigen::VectorXd nu;      ///< one a peak limit
  Eigen::MatrixXd lifted;  ///< 𝒜 ⪰ 0, p x p: amplitudes a aᵀ with the rank constraint dropped
  Eigen::VectorXd mean;    ///< column 0 of 𝒜, p; zero if there is no x_0 and no peak limit
  double gap = 0.0;        ///< of ½‖a‖²
  int iterations = 0;
  bool converged = false;
};

/// Solves whichever of the two has fewer unknowns, n(n+1)/2 against p(p+1)/2; with peak limits the
/// first, which always has a strictly feasible start.
/// @param reference   â with N(â) ⪰ R, of size one
/// @param stop_above  ends early once the lower bound of ½‖a‖² exceeds it
RelaxedSolution solveRelaxed(const QuadraticProgram& program, const Eigen::VectorXd& reference,
                             double gap,
                             double stop_above = std::numeric_limits<double>::infinity());

/// The two programs as they are handed to the solver, for tests and comparisons.
LmiProgram dualProgram(const QuadraticProgram& program);
Eigen::VectorXd dualStart(const QuadraticProgram& program);
LmiProgram liftedProgram(const QuadraticProgram& program);
Eigen::VectorXd liftedStart(const QuadraticProgram& program, const Eigen::VectorXd& reference);

}  // namespace explore_opt
