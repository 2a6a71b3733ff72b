#include "inner_relaxation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "barrier_program.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBarrierShrink =
    1e-3;                         // of the barrier weight; smaller ones make Newton's steps crawl
constexpr double kMargin = 1e-3;  // start of a relaxation outside the boundary

/// A little outside the boundary the relaxation is strictly feasible: surely from rest, where N
/// grows with the square; with x_0 for some margin, unless ã is a point the boundary touches from
/// outside.
double marginOf(const BarrierProgram& relaxation, const VectorXd& candidate) {
  for (const double margin : {kMargin, 1e-4, 1e-5, 1e-2, 1e-6}) {
    const Eigen::LLT<MatrixXd> llt(relaxation.slack((1.0 + margin) * candidate));
    if (llt.info() == Eigen::Success) return margin;
  }
  return 0.0;
}

}  // namespace

InnerSolution solveInnerRelaxation(const QuadraticProgram& program, IpoptSolver& solver,
                                   const VectorXd& candidate, double last_gap) {
  BarrierProgram relaxation(program, candidate);
  const int n = program.size();
  InnerSolution inner;
  const double margin = marginOf(relaxation, candidate);
  if (margin == 0.0) return inner;
  inner.a = (1.0 + margin) * candidate;
  const double last = last_gap / n;
  double mu = std::max(last, 0.5 * margin * candidate.squaredNorm() / n);
  for (;;) {
    relaxation.setWeight(mu);
    const SolverAnswer answer = solver.solve(relaxation, {inner.a, {}});
    double f = 0.0;
    if (answer.status == SolverStatus::kFailed || !relaxation.objective(answer.x, f)) return inner;
    inner.a = answer.x;
    inner.Z = relaxation.certificate(inner.a);
    inner.gap = relaxation.gap(inner.a);
    inner.centred = inner.gap <= 1.5 * n * mu;  // exactly n μ at the centre
    if (mu <= last) return inner;
    mu = std::max(last, kBarrierShrink * mu);
  }
}

}  // namespace explore_opt
