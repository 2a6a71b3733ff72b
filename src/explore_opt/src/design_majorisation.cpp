#include <fmt/core.h>

#include <cmath>

#include "barrier_program.hpp"
#include "checks.hpp"
#include "design_tools.hpp"
#include "dual_bound.hpp"
#include "ipopt_solver.hpp"
#include "quad_support/interrupt.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSolverTolerance = 1e-9;
constexpr int kSolverIterations = 200;
constexpr double kShrink = 0.02;  // of the barrier weight

/// Solution of one relaxation, in scaled coordinates.
struct InnerSolution {
  VectorXd a;
  MatrixXd Z;
  double gap = 0.0;
  bool centred = false;
};

/// Follows the barrier's path from (1 + margin) ã, strictly inside because ã is on the boundary and N grows with the
/// square, down to the weight whose gap n μ is `last_gap`.
InnerSolution solveRelaxation(const QuadraticProgram& program, IpoptSolver& solver, const VectorXd& candidate,
                              double margin, double last_gap) {
  BarrierProgram relaxation(program, candidate);
  const int n = program.size();
  InnerSolution inner;
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
    mu = std::max(last, kShrink * mu);
  }
}

void record(const DesignTask& task, RawDesign& design, const VectorXd& a, double gap) {
  DesignIteration iteration;
  iteration.gamma_e = a.norm();
  iteration.step = design.iterations.empty() ? 0.0 : (a - design.amplitudes).norm();
  iteration.inner_gap = gap;
  iteration.amplitudes = task.table(a);
  design.iterations.push_back(iteration);
  design.amplitudes = a;
  design.inner_gap = gap;
}

VectorXd startOf(const DesignTask& task, const DesignOptions& options, RawDesign& design) {
  const auto p = task.response.numAmplitudes();
  if (options.initial_amplitudes.size() > 0) {
    requireShape(options.initial_amplitudes, p, 1, "initial amplitudes");
    if (task.excites(options.initial_amplitudes)) return task.onBoundary(options.initial_amplitudes);
    design.message = "the initial amplitudes do not excite all parameters; change their direction, size does not matter";
    return {};
  }
  if (task.excites(VectorXd::Ones(p))) return task.onBoundary(VectorXd::Ones(p));
  if (const auto start = cheapestSimpleDirection(task, options.seed)) return *start;
  design.message = "no amplitudes of these lines excite all parameters; add lines or samples";
  return {};
}

/// One re-linearisation; true if it converged. A step that does not lower the cost is not taken.
bool improve(const DesignTask& task, const DesignOptions& options, IpoptSolver& solver, RawDesign& design) {
  const VectorXd before = design.amplitudes;
  const QuadraticProgram program(task.response, task.gamma_w, before);
  const DesignIteration& last = design.iterations.back();
  const double margin = design.iterations.size() == 1 ? 0.2 : std::clamp(last.step / last.gamma_e, 1e-6, 0.2);
  const InnerSolution inner =
      solveRelaxation(program, solver, program.toScaled(before), margin, 0.5 * options.inner_gap);
  if (inner.Z.size() > 0) {
    const Certificate certificate = task.certify(program.toCertificate(inner.Z));
    if (certificate.bound > design.certificate.bound) design.certificate = certificate;
  }
  design.status = inner.centred ? DesignStatus::kSolved : DesignStatus::kReducedAccuracy;
  const VectorXd a = inner.Z.size() > 0 ? task.onBoundary(program.toAmplitudes(inner.a)) : before;
  const double decrease = before.norm() - a.norm();
  if (!(decrease > 0.0)) return true;
  record(task, design, a, inner.gap * before.squaredNorm());
  return decrease <= options.cost_tolerance * a.norm() && (a - before).norm() <= options.step_tolerance * a.norm();
}

}  // namespace

RawDesign designByMajorisation(const DesignTask& task, const DesignOptions& options) {
  RawDesign design;
  const VectorXd start = startOf(task, options, design);
  if (start.size() == 0) {
    design.status = DesignStatus::kNotExciting;
    return design;
  }
  record(task, design, start, 0.0);
  IpoptSolver solver(kSolverTolerance, kSolverIterations);
  bool converged = false;
  int iterations = 0;
  while (!converged && iterations < options.max_iterations) {
    quad_support::throwIfInterrupted();
    converged = improve(task, options, solver, design);
    ++iterations;
  }
  if (!converged) design.status = DesignStatus::kIterationLimit;
  const QuadraticProgram program(task.response, task.gamma_w, design.amplitudes);
  const Certificate dual = task.certify(program.toCertificate(solveDual(program, 1e-9).Z));
  if (dual.bound > design.certificate.bound) design.certificate = dual;
  design.message = fmt::format("{} re-linearisations, {}", iterations,
                               converged ? "cost and step below their thresholds" : "limit reached");
  return design;
}

}  // namespace explore_opt
