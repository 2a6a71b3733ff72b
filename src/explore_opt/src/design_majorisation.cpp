#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <optional>

#include "checks.hpp"
#include "design_tools.hpp"
#include "inner_relaxation.hpp"
#include "quad_support/interrupt.hpp"
#include "relaxation.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSolverTolerance = 1e-9;
constexpr int kSolverIterations = 200;

void record(const DesignTask& task, RawDesign& design, const VectorXd& a, double gap) {
  DesignIteration iteration;
  iteration.gamma_e = task.costAt(a);
  iteration.step = design.iterations.empty() ? 0.0 : (a - design.amplitudes).norm();
  iteration.inner_gap = gap;
  iteration.amplitudes = task.table(a);
  design.iterations.push_back(iteration);
  design.amplitudes = a;
  design.inner_gap = gap;
}

/// The cheapest of random directions. Several experiments must not begin alike: what is the same in
/// all of them stays the same in every step.
VectorXd unlikeExperiments(const DesignTask& task, std::uint64_t seed) {
  VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint64_t i = 0; i < 32; ++i) {
    const VectorXd direction = randomDirection(task, seed, i);
    const double cost = task.cost(direction);
    if (cost >= least) continue;
    least = cost;
    best = direction;
  }
  return best.size() > 0 ? task.onBoundary(best) : best;
}

VectorXd startOf(const ExplorationProblem& problem, const DesignTask& task,
                 const DesignOptions& options, RawDesign& design) {
  const auto p = task.response.numAmplitudes();
  if (options.initial_amplitudes.size() > 0) {
    requireShape(options.initial_amplitudes, p, 1, "initial amplitudes");
    const VectorXd candidate = task.components(
        options.initial_amplitudes.reshaped<Eigen::RowMajor>(p / task.num_inputs, task.num_inputs));
    if (std::isfinite(task.cost(candidate))) return task.onBoundary(candidate);
    design.status = DesignStatus::kNotExciting;
    design.message =
        "the initial amplitudes do not excite all parameters; change their direction, size does "
        "not matter";
    return {};
  }
  if (task.runs > 1) {
    const VectorXd start = unlikeExperiments(task, options.seed);
    if (start.size() > 0) return start;
  }
  if (problem.numInputs() == 1 && std::isfinite(task.cost(VectorXd::Ones(p))))
    return task.onBoundary(VectorXd::Ones(p));  // equal inputs are all but singular for n_u >= 2
  if (const auto start = cheapestSimpleDirection(task, options.seed)) return *start;
  refuseToExcite(problem, task, design);
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
    if (!(task.cost(direction) < task.costAt(best))) break;
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
  const InnerSolution inner =
      solveInnerRelaxation(program, solver, program.toScaled(before), 0.5 * gap);
  design.status = inner.centred ? DesignStatus::kSolved : DesignStatus::kReducedAccuracy;
  if (inner.Z.size() == 0) return Outcome::kNoDecrease;
  const Certificate certificate = task.certify(program.toRoot(inner.Z));
  if (certificate.bound > design.certificate.bound) design.certificate = certificate;

  VectorXd a = task.onBoundary(program.toAmplitudes(inner.a));
  if (a.size() == 0) return Outcome::kNoDecrease;
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

RawDesign designByMajorisation(const ExplorationProblem& problem, const DesignTask& single,
                               const DesignOptions& options) {
  const DesignTask task = single.replicated(problem.experiments);
  RawDesign design;
  const VectorXd start = startOf(problem, task, options, design);
  if (start.size() == 0) return design;
  record(task, design, start, 0.0);
  if (!(start.norm() > 0.0)) {
    design.status = DesignStatus::kSolved;
    design.message = "the response to x0 satisfies the condition without a signal";
    design.certificate.bound = std::sqrt(task.map.floor) * (1.0 - 1e-13);
    return design;
  }
  const bool converged = iterate(task, options, design);
  if (!converged) design.status = DesignStatus::kIterationLimit;
  const auto reference = task.runs == 1 ? std::optional<VectorXd>(design.amplitudes)
                                        : cheapestSimpleDirection(single, options.seed);
  if (isSmallEnough(single) && reference) {
    const QuadraticProgram program(single.response, single.gamma_w, *reference);
    const RelaxedSolution relaxed = solveRelaxed(program, program.toScaled(*reference), 1e-9);
    const Certificate dual = single.certify(program.toRoot(relaxed.Z));
    if (dual.bound > design.certificate.bound) design.certificate = dual;
  }
  design.message =
      fmt::format("{} steps, {}", design.iterations.size() - 1,
                  converged ? "cost and step below their thresholds" : "iteration limit reached");
  return design;
}

}  // namespace explore_opt
