/// A small dense solver for linear matrix inequalities: what is convex in exploration design.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace explore_opt {

/// S(y) = C + Σ_k y_k A_k ⪰ 0 over variables first, first + 1, ... of the program.
struct LmiBlock {
  Eigen::MatrixXd constant;  ///< C, symmetric
  int first = 0;
  /// Number of variables in this block
  int count = 0;
  /// A_k, symmetric. Empty: the variables are the entries of S themselves, its lower triangle row
  /// by row (entries beyond `count` keep their constant).
  std::vector<Eigen::MatrixXd> slopes;

  int size() const { return static_cast<int>(constant.rows()); }
  Eigen::MatrixXd at(const Eigen::VectorXd& y) const;  ///< S(y)
  /// Σ_k d_k A_k
  Eigen::MatrixXd change(const Eigen::VectorXd& d) const;
};

/// max bᵀy  s.t.  every block ⪰ 0.   Dual: min Σ tr(C_j X_j)  s.t.  -Σ_j tr(A_jk X_j) = b_k, X ⪰ 0.
struct LmiProgram {
  Eigen::VectorXd reward;  ///< b
  std::vector<LmiBlock> blocks;
};

struct LmiSolution {
  Eigen::VectorXd y;                                     ///< strictly feasible
  std::vector<Eigen::MatrixXd> multipliers;              ///< X_j ≻ 0, one a block
  double gap = std::numeric_limits<double>::infinity();  ///< Σ tr(X_j S_j)
  /// |b_k + Σ_j tr(A_jk X_j)|, the largest
  double residual = std::numeric_limits<double>::infinity();
  int iterations = 0;
  bool converged = false;  ///< gap and residual are as small as asked
};

/// Primal-dual path following in Nesterov's and Todd's scaling, with Mehrotra's corrector. Every y
/// stays strictly feasible, so bᵀy is a valid value whenever it stops. The step's normal equations
/// are formed by products of large matrices, factorised by Cholesky and refined; where that does
/// not reach full accuracy, near the end, by a QR of their root.
/// @param start  strictly feasible
/// @param gap    of bᵀy, absolute; the residual is asked for to the same size
/// @param stop_above  ends early once bᵀy exceeds it (an unbounded program does sooner or later)
LmiSolution solveLmi(const LmiProgram& program, const Eigen::VectorXd& start, double gap,
                     double stop_above = std::numeric_limits<double>::infinity());

}  // namespace explore_opt
