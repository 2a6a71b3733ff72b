#include "local_search.hpp"

#include <cmath>

#include "barrier_descent.hpp"
#include "constants.hpp"
#include "factor_program.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kKktTolerance = 1e-6;
constexpr double kPeakTolerance = 1e-7;  // of squares; Ipopt ends within 1e-8, the limits keep
                                         // 1e-7 of the peak itself in reserve
constexpr double kSameCost = 1e-8;       // relative; the barrier ends within its gap of a minimum

/// On the boundary; empty if it is not feasible.
VectorXd pulledBack(const DesignTask& task, const VectorXd& a) {
  if (!a.allFinite() || !(a.norm() > 0.0) || !std::isfinite(task.cost(a))) return {};
  const VectorXd b = task.onBoundary(a);
  for (const PeakConstraint& peak : task.peaks) {
    if (b.size() == 0 || peak.room(b) < -kPeakTolerance) return {};
  }
  return b;
}

/// Largest of the peaks over their limits.
double highestPeak(const std::vector<PeakConstraint>& peaks, const VectorXd& a) {
  double least = 1.0;
  for (const PeakConstraint& peak : peaks) least = std::min(least, peak.room(a));
  return std::sqrt(1.0 - least);
}

/// From a strictly feasible point near `start`: outside the boundary, but within the peaks.
BarrierPoint descendFromNear(const QuadraticProgram& scaled, const VectorXd& start, double margin,
                             double gap) {
  for (const double outside : {margin, 1e-3, 1e-4, 1e-6, 1e-8, 0.0}) {
    const BarrierPoint point = descendBarrier(scaled, (1.0 + outside) * start, gap);
    if (point.a.size() > 0 || scaled.peaks().empty()) return point;
  }
  return {};
}

/// By the barrier: its last centre is within 1e-9 of a local minimum's cost.
LocalSolution descend(const DesignTask& task, const QuadraticProgram& scaled, const VectorXd& start,
                      double margin, LocalSolution solution) {
  const BarrierPoint point =
      descendFromNear(scaled, scaled.toScaled(start), std::max(margin, 1e-2), 1e-9);
  if (point.a.size() == 0) return solution;
  const VectorXd a = pulledBack(task, scaled.toAmplitudes(point.a));
  const double before = solution.amplitudes.size() > 0 ? solution.amplitudes.norm() : kInfinity;
  if (a.size() == 0 || a.norm() > (1.0 + kSameCost) * before) return solution;
  if (a.norm() < before) solution.amplitudes = a;  // else it began at the minimum
  solution.root = scaled.toRoot(point.Z);
  solution.nu = scaled.toCost(1.0) * point.nu;
  solution.optimal = satisfiesKkt(scaled, scaled.toScaled(solution.amplitudes), point.Z, point.nu);
  solution.status = solution.optimal ? SolverStatus::kConverged : SolverStatus::kStalled;
  return solution;
}

}  // namespace

VectorXd glimpse(const DesignTask& task, const VectorXd& start) {
  const bool within = !task.peaks.empty();
  const VectorXd reference = within ? task.onBoundary(start) : start;
  if (reference.size() == 0) return {};
  const QuadraticProgram scaled(task.response, task.gamma_w, reference, task.peaks);
  const BarrierPoint point =
      descendBarrier(scaled, (within ? 1.0 : 1.2) * scaled.toScaled(start), 1e-4);
  return point.a.size() > 0 ? pulledBack(task, scaled.toAmplitudes(point.a)) : VectorXd();
}

VectorXd towardsLeastPeak(const DesignTask& task, const VectorXd& start) {
  constexpr int kMostCentres = 300;
  constexpr double kSlack = 2e-3;     // of the limits above the peaks of the last centre
  constexpr double kProgress = 1e-4;  // least decrease a centre
  constexpr double kInside = 1e-4;    // enough for the barrier to start from
  DesignTask relaxed = task;
  VectorXd a = start;
  for (int i = 0; i < kMostCentres; ++i) {
    const double ratio = highestPeak(task.peaks, a);
    if (ratio < 1.0 - kInside) break;
    for (std::size_t k = 0; k < task.peaks.size(); ++k)
      relaxed.peaks[k].limit = (1.0 + kSlack) * ratio * task.peaks[k].limit;
    const VectorXd reference = task.onBoundary(a);
    if (reference.size() == 0) return {};
    const QuadraticProgram scaled(task.response, task.gamma_w, reference, relaxed.peaks);
    const BarrierPoint point = descendBarrier(scaled, scaled.toScaled(a), 0.1);
    if (point.a.size() == 0) break;
    const VectorXd next = scaled.toAmplitudes(point.a);
    if (!(highestPeak(task.peaks, next) < (1.0 - kProgress) * ratio)) break;
    a = next;
  }
  return a;
}

bool satisfiesKkt(const QuadraticProgram& program, const VectorXd& a, const MatrixXd& Z,
                  const VectorXd& nu) {
  VectorXd slope = a - 2.0 * program.H(Z) * a;
  for (int i = 0; i < program.numAmplitudes() && !program.homogeneous(); ++i)
    slope(i) -= 2.0 * Z.cwiseProduct(program.S_0(i)).sum();
  double slack = Z.cwiseProduct(program.N(a) - program.rightSide()).sum();
  for (Index k = 0; k < nu.size(); ++k) {
    const PeakConstraint& peak = program.peaks()[static_cast<std::size_t>(k)];
    slope += nu(k) * peak.rows.transpose() * (peak.rows * a + peak.offset);
    slack += std::abs(nu(k) * peak.room(a));
  }
  const double least = quad_support::symmetricEigenvalues(Z)(0);
  return slope.norm() <= kKktTolerance * a.norm() &&
         least >= -kKktTolerance * std::abs(Z.trace()) &&
         (nu.size() == 0 || nu.minCoeff() >= -kKktTolerance * nu.cwiseAbs().maxCoeff()) &&
         std::abs(slack) <= kKktTolerance * a.squaredNorm();
}

LocalSolution polish(const DesignTask& task, IpoptSolver& solver, const VectorXd& start,
                     double margin, const Certificate* multiplier) {
  const QuadraticProgram scaled(task.response, task.gamma_w, start, task.peaks);
  LocalSolution solution;
  solution.nu = VectorXd::Zero(static_cast<Index>(task.peaks.size()));
  solution.amplitudes = pulledBack(task, start);
  if (scaled.size() > kLargestFactorProgram)
    return descend(task, scaled, start, margin, std::move(solution));
  FactorProgram program(scaled);
  SolverStart from;
  from.x = program.startAt((1.0 + margin) * scaled.toScaled(start));
  const double square = scaled.toCost(1.0);
  if (multiplier != nullptr && multiplier->nu.size() == solution.nu.size()) {
    from.multipliers =
        program.multipliersOf(scaled.fromRoot(multiplier->root), multiplier->nu / square);
  }
  const SolverAnswer answer = solver.solve(program, from);
  solution.status = answer.status;
  if (answer.status == SolverStatus::kFailed) return solution;
  const VectorXd a = pulledBack(task, scaled.toAmplitudes(program.amplitudesOf(answer.x)));
  if (a.size() == 0) return solution;
  // A solver that gave up may have wandered off to something dearer than where it began.
  if (solution.amplitudes.size() > 0 && answer.status != SolverStatus::kConverged &&
      a.norm() > solution.amplitudes.norm())
    return solution;
  const MatrixXd Z = program.certificateOf(answer.multipliers);
  const VectorXd nu = program.peakMultipliersOf(answer.multipliers);
  solution.amplitudes = a;
  solution.root = scaled.toRoot(Z);
  solution.nu = square * nu;
  solution.optimal = satisfiesKkt(scaled, scaled.toScaled(a), Z, nu);
  return solution;
}

}  // namespace explore_opt
