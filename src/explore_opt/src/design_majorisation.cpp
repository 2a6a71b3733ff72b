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
constexpr double kShrink = 1e-3;  // of the barrier weight; smaller ones make Newton's steps crawl
constexpr double kMargin = 1e-3;  // start of a relaxation outside the boundary

/// Solution of one relaxation, in scaled coordinates.
struct InnerSolution {
  VectorXd a;
  MatrixXd Z;
  double gap = 0.0;
  bool centred = false;
};

/// Follows the barrier's path from (1 + 1e-3) ã, strictly inside because ã is on the boundary and N
/// grows with the square, down to the weight whose gap n μ is `last_gap`.
InnerSolution solveRelaxation(const QuadraticProgram& program, IpoptSolver& solver,
                              const VectorXd& candidate, double last_gap) {
  BarrierProgram relaxation(program, candidate);
  const int n = program.size();
  InnerSolution inner;
  inner.a = (1.0 + kMargin) * candidate;
  const double last = last_gap / n;
  double mu = std::max(last, 0.5 * kMargin * candidate.squaredNorm() / n);
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
    if (task.excites(options.initial_amplitudes))
      return task.onBoundary(options.initial_amplitudes);
    design.message =
        "the initial amplitudes do not excite all parameters; change their direction, size does "
        "not matter";
    return {};
  }
  if (task.excites(VectorXd::Ones(p))) return task.onBoundary(VectorXd::Ones(p));
  if (const auto start = cheapestSimpleDirection(task, options.seed)) return *start;
  design.message = "no amplitudes of these lines excite all parameters; add lines or samples";
  return {};
}

/// Accuracy of the next relaxation: a hundredth of what the last one gained, down to the one asked
/// for.
double innerGap(const std::vector<DesignIteration>& done, const DesignOptions& options) {
  if (done.size() < 2) return std::max(options.inner_gap, 1e-4);
  const double gained = 1.0 - done.back().gamma_e / done[done.size() - 2].gamma_e;
  return std::clamp(0.01 * gained, options.inner_gap, std::max(options.inner_gap, 1e-4));
}

/// Goes on from `before` over `after` with doubled steps, on the boundary, as long as that is
/// cheaper.
VectorXd extrapolated(const DesignTask& task, const VectorXd& before, const VectorXd& after) {
  VectorXd best = after;
  for (double factor = 2.0; factor <= 1024.0; factor *= 2.0) {
    const VectorXd direction = before + factor * (after - before);
    if (!(task.cost(direction) < best.norm())) break;
    best = task.onBoundary(direction);
  }
  return best;
}

enum class Outcome { kImproved, kConverged, kNoDecrease };

/// One re-linearisation with inner accuracy `gap`. A step that does not lower the cost is not
/// taken.
Outcome improve(const DesignTask& task, const DesignOptions& options, double gap,
                IpoptSolver& solver, RawDesign& design) {
  const VectorXd before = design.amplitudes;
  const QuadraticProgram program(task.response, task.gamma_w, before);
  const InnerSolution inner = solveRelaxation(program, solver, program.toScaled(before), 0.5 * gap);
  design.status = inner.centred ? DesignStatus::kSolved : DesignStatus::kReducedAccuracy;
  if (inner.Z.size() == 0) return Outcome::kNoDecrease;
  const Certificate certificate = task.certify(program.toCertificate(inner.Z));
  if (certificate.bound > design.certificate.bound) design.certificate = certificate;

  VectorXd a = task.onBoundary(program.toAmplitudes(inner.a));
  if (options.extrapolate) a = extrapolated(task, before, a);
  const double decrease = before.norm() - a.norm();
  if (!(decrease > 0.0)) return Outcome::kNoDecrease;
  record(task, design, a, inner.gap * before.squaredNorm());
  const bool small = decrease <= options.cost_tolerance * a.norm() &&
                     (a - before).norm() <= options.step_tolerance * a.norm();
  return small ? Outcome::kConverged : Outcome::kImproved;
}

/// Re-linearises until nothing changes; false if the iterations ran out. Without a decrease it goes
/// on once with the full inner accuracy before it believes that there is none.
bool iterate(const DesignTask& task, const DesignOptions& options, RawDesign& design) {
  IpoptSolver solver(kSolverTolerance, kSolverIterations);
  bool accurate = false;
  for (int i = 0; i < options.max_iterations; ++i) {
    quad_support::throwIfInterrupted();
    const double gap = accurate ? options.inner_gap : innerGap(design.iterations, options);
    const Outcome outcome = improve(task, options, gap, solver, design);
    if (outcome == Outcome::kConverged) return true;
    if (outcome == Outcome::kNoDecrease && gap <= options.inner_gap) return true;
    accurate = outcome == Outcome::kNoDecrease;
  }
  return false;
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
  const bool converged = iterate(task, options, design);
  if (!converged) design.status = DesignStatus::kIterationLimit;
  const QuadraticProgram program(task.response, task.gamma_w, design.amplitudes);
  const Certificate dual = task.certify(program.toCertificate(solveDual(program, 1e-9).Z));
  if (dual.bound > design.certificate.bound) design.certificate = dual;
  design.message =
      fmt::format("{} steps, {}", design.iterations.size() - 1,
                  converged ? "cost and step below their thresholds" : "iteration limit reached");
  return design;
}

}  // namespace explore_opt
