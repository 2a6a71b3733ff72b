#include "global_search.hpp"

#include <fmt/core.h>

#include <cmath>

#include "relaxation.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRelaxedGap = 1e-9;  // of ½γ_e²; what the polished multipliers cannot improve
                                      // is left to them
constexpr int kRoundings = 32;
constexpr double kRankTolerance = 1e-4;  // of the largest eigenvalue

/// The leading eigenvectors of 𝒜, one a run.
VectorXd leading(const DesignTask& task, const Relaxed& relaxed) {
  const VectorXd roots = relaxed.lifted.values.cwiseMax(0.0).cwiseSqrt();
  const Index p = roots.size();
  VectorXd direction = VectorXd::Zero(p * task.runs);
  for (int i = 0; i < task.runs; ++i) {
    const Index column = p - 1 - std::min<Index>(i, p - 1);
    direction.segment(i * p, p) =
        relaxed.mean / std::sqrt(double(task.runs)) +
        (relaxed.mean.isZero(0.0) ? 1.0 : 0.0) * roots(column) * relaxed.lifted.vectors.col(column);
  }
  return direction;
}

}  // namespace

Relaxed relax(const DesignTask& task, const VectorXd& start, double stop_above) {
  const QuadraticProgram scaled(task.response, task.gamma_w, start, task.peaks);
  const double square = scaled.toCost(1.0);
  const double most = 0.5 * (stop_above * stop_above - task.map.floor) / square;
  const RelaxedSolution solution =
      solveRelaxed(scaled, scaled.toScaled(start), kRelaxedGap, 1.001 * most);
  const MatrixXd centred = solution.lifted - solution.mean * solution.mean.transpose();
  Relaxed relaxed{task.certify(scaled.toRoot(solution.Z), square * solution.nu),
                  scaled.toAmplitudes(solution.mean),
                  quad_support::SymmetricEigen(square * centred), 0};
  const VectorXd all = quad_support::symmetricEigenvalues(solution.lifted);
  for (Index i = 0; i < all.size(); ++i)
    relaxed.rank += all(i) > kRankTolerance * all(all.size() - 1) ? 1 : 0;
  return relaxed;
}

VectorXd drawn(const DesignTask& task, const Relaxed& relaxed, std::uint64_t seed,
               std::uint64_t index) {
  const VectorXd roots = relaxed.lifted.values.cwiseMax(0.0).cwiseSqrt();
  VectorXd direction = randomDirection(task, seed, index);
  const Index p = roots.size();
  for (int i = 0; i < task.runs; ++i) {
    const VectorXd weights = roots.cwiseProduct(direction.segment(i * p, p));
    direction.segment(i * p, p) =
        (relaxed.mean + relaxed.lifted.vectors * weights) / std::sqrt(double(task.runs));
  }
  return direction;
}

VectorXd roundLifted(const DesignTask& task, const Relaxed& relaxed, const VectorXd& fallback,
                     std::uint64_t seed) {
  VectorXd best = fallback;
  double least = fallback.size() > 0 ? task.cost(fallback) : kInfinity;
  for (int i = 0; i <= kRoundings; ++i) {
    const VectorXd direction =
        i == 0 ? leading(task, relaxed)
               : drawn(task, relaxed, seed, 1000 + static_cast<std::uint64_t>(i));
    const double cost = task.cost(direction);
    if (cost < least) {
      least = cost;
      best = task.onBoundary(direction);
    }
    if (i == 0 && relaxed.rank <= task.runs && std::isfinite(cost)) break;  // nothing to round
  }
  return best;
}

std::string globallyOptimal(double gap) {
  return fmt::format("globally optimal to {:.2g} (certified)", std::abs(gap));
}

void conclude(const Search& search, const DesignOptions& options, const std::string& advice,
              RawDesign& design) {
  const std::string solves = search.failures() == 0
                                 ? ""
                                 : fmt::format(" ({} of {} local solves did not converge)",
                                               search.failures(), search.solves());
  if (search.gap() <= options.gap_tolerance) {
    design.status = DesignStatus::kSolved;
    design.message = globallyOptimal(search.gap());
  } else if (search.optimal()) {
    design.status = DesignStatus::kSolved;
    design.message =
        fmt::format("best local optimum of {} starts; certified within {:.2g} of the global one{}",
                    search.starts(), search.gap(), advice);
  } else {
    design.status = DesignStatus::kReducedAccuracy;
    design.message =
        fmt::format("feasible, certified within {:.2g} of the optimum, but not a KKT point{}{}",
                    search.gap(), solves, advice);
  }
}

}  // namespace explore_opt
