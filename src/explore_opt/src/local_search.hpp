/// Local solutions of the design problem by the factor program, judged from the data.
#pragma once

#include "design_tools.hpp"
#include "ipopt_solver.hpp"

namespace explore_opt {

/// Feasible amplitudes on the boundary, multipliers, and whether both satisfy the KKT conditions.
struct LocalSolution {
  Eigen::VectorXd amplitudes;  ///< empty: none found
  Eigen::MatrixXd root;        ///< of the multiplier's positive part; empty: none found
  Eigen::VectorXd nu;
  bool optimal = false;
  SolverStatus status = SolverStatus::kFailed;
};

/// Runs the factor program in Ipopt from (1 + margin) times `start`, a boundary point; a multiplier
/// warm-starts the solver's. Every outcome of the solver is taken for what it is worth: the last
/// iterate is scaled back to the boundary and used if that succeeds. Conditions of order above
/// kLargestFactorProgram go to descendBarrier() instead.
LocalSolution polish(const DesignTask& task, IpoptSolver& solver, const Eigen::VectorXd& start,
                     double margin, const Certificate* multiplier);

/// The local minimum `start` leads to, to about 1e-4 of its cost, by the barrier: a fifth of the
/// time of polish(), to see whether polishing is worth while. On the boundary; empty if there is
/// none. With peaks the start must be strictly feasible, without on the boundary.
Eigen::VectorXd glimpse(const DesignTask& task, const Eigen::VectorXd& start);

/// A point of lower peaks than `start`, strictly feasible as it but for the peaks: down to within
/// the limits, or to a local minimum of the largest peak relative to its limit. By centres of the
/// barrier under limits that close in (Huard's method), where the limits of `task` need not hold.
Eigen::VectorXd towardsLeastPeak(const DesignTask& task, const Eigen::VectorXd& start);

/// n(n+1)/2 equations with n³/3 derivatives: at n = 18 a solve takes a second, the barrier 20 ms.
constexpr int kLargestFactorProgram = 12;

/// a = 2 H(Z) a + 2 h(Z) - Σ ν_k Q_kᵀ(Q_k a), Z ⪰ 0, ν >= 0, complementarity, each to 1e-6 of its
/// size: judged from the data, not by the solver. All in the program's scaled coordinates, for in
/// others the products cancel where responses grow.
bool satisfiesKkt(const QuadraticProgram& program, const Eigen::VectorXd& a,
                  const Eigen::MatrixXd& Z, const Eigen::VectorXd& nu);

}  // namespace explore_opt
