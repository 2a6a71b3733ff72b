/// Ipopt behind a few types of our own; its headers are included by ipopt_solver.cpp alone.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "smooth_program.hpp"

namespace explore_opt {

enum class SolverStatus { kConverged, kAcceptable, kStalled, kIterationLimit, kFailed };

struct SolverAnswer {
  SolverStatus status = SolverStatus::kFailed;
  Eigen::VectorXd x;            ///< last iterate; empty if there was none
  Eigen::VectorXd multipliers;  ///< λ with ∇f + Jᵀ λ = 0, λ <= 0 where c >= 0
  int iterations = 0;
};

struct SolverStart {
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers;  ///< empty: estimated by least squares
};

/// Ipopt with MUMPS, silent, reading no options file. Setting up costs a millisecond: keep it for
/// many solves.
class IpoptSolver {
 public:
  /// @throws quad_support::EnvironmentError if Ipopt cannot be set up
  IpoptSolver(double tolerance, int max_iterations);
  ~IpoptSolver();
  SolverAnswer solve(SmoothProgram& program, const SolverStart& start);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace explore_opt
