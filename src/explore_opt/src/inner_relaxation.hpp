/// The relaxation the paper's algorithm solves in each of its steps.
#pragma once

#include "ipopt_solver.hpp"
#include "quadratic_program.hpp"

namespace explore_opt {

/// Solution of one relaxation, in scaled coordinates.
struct InnerSolution {
  Eigen::VectorXd a;
  Eigen::MatrixXd Z;  ///< empty: no solution
  double gap = 0.0;
  bool centred = false;
};

/// Follows the barrier's path from just outside ã down to the weight whose gap n μ is `last_gap`.
InnerSolution solveInnerRelaxation(const QuadraticProgram& program, IpoptSolver& solver,
                                   const Eigen::VectorXd& candidate, double last_gap);

}  // namespace explore_opt
