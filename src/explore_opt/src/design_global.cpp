#include <fmt/core.h>

#include <cmath>

#include "design_within_peaks.hpp"
#include "global_search.hpp"
#include "quad_support/interrupt.hpp"

namespace explore_opt {
namespace {

using Eigen::VectorXd;

/// Whether two local minima are the same up to sign: they are when they cost the same and point in
/// almost the same direction.
bool same(const VectorXd& a, const VectorXd& b) {
  return std::abs(a.dot(b)) > (1.0 - 1e-4) * a.norm() * b.norm();
}

/// Further starts, every other one drawn from the relaxation, until the gap is closed. Only those
/// are polished that lead to something cheaper, or to as cheap a point elsewhere.
void searchOn(Search& search, const DesignTask& task, const Relaxed* relaxed,
              const DesignOptions& options, IpoptSolver& solver) {
  for (int i = 0; i < options.random_starts && search.gap() > options.gap_tolerance; ++i) {
    quad_support::throwIfInterrupted();
    const auto index = static_cast<std::uint64_t>(i);
    const VectorXd direction = relaxed != nullptr && i % 2 == 0
                                   ? drawn(task, *relaxed, options.seed, index)
                                   : randomDirection(task, options.seed, index);
    if (!std::isfinite(task.cost(direction))) continue;
    search.tried();
    const VectorXd start = task.onBoundary(direction);
    if (!search.found()) {
      search.add(polish(task, solver, start, 0.2, nullptr));
      continue;
    }
    const VectorXd seen = glimpse(task, start);
    if (seen.size() == 0 || seen.norm() > (1.0 + kGlimpsed) * search.best().norm()) continue;
    if (seen.norm() < (1.0 - kGlimpsed) * search.best().norm() || !same(seen, search.best()))
      search.add(polish(task, solver, seen, 1e-2, nullptr));
  }
}

/// To fly several experiments, where that may close the gap; they are not solved with u_max.
std::string advice(const ExplorationProblem& problem, const RawDesign& design) {
  if (design.rank <= problem.experiments || problem.u_max.size() > 0) return "";
  return fmt::format(
      "; the relaxation has rank {0}, so one experiment may not reach the bound: \"experiments\": "
      "{0} meets it as root mean square per run",
      design.rank);
}

/// Without peak limits.
RawDesign designFreely(const ExplorationProblem& problem, const DesignTask& single,
                       const DesignOptions& options) {
  RawDesign design;
  const auto start = cheapestSimpleDirection(single, options.seed);
  if (!start) {
    refuseToExcite(problem, single, design);
    return design;
  }
  if (!(start->norm() > 0.0)) {  // x_0 alone is exciting enough
    design.status = DesignStatus::kSolved;
    design.message = "the response to x0 satisfies the condition without a signal";
    design.amplitudes = *start;
    design.certificate.bound = std::sqrt(single.map.floor) * (1.0 - 1e-13);
    return design;
  }
  const DesignTask task = single.replicated(problem.experiments);
  Search search(single, task, design);
  std::optional<Relaxed> relaxed;
  if (isSmallEnough(single)) {
    relaxed = relax(single, *start);
    design.rank = relaxed->rank;
    search.improveCertificate(relaxed->certificate);
  }
  const VectorXd fallback = start->replicate(task.runs, 1) / std::sqrt(double(task.runs));
  const VectorXd first = relaxed ? roundLifted(task, *relaxed, fallback, options.seed) : fallback;
  search.start(first);
  IpoptSolver solver(kLiftedTolerance, kLiftedIterations);
  const double margin = search.gap() < 1e-4 ? 1e-6 : 0.2;
  search.add(polish(task, solver, first, margin,
                    design.certificate.bound > 0.0 ? &design.certificate : nullptr));
  searchOn(search, task, relaxed ? &*relaxed : nullptr, options, solver);
  conclude(search, options, advice(problem, design), design);
  return design;
}

}  // namespace

RawDesign designGlobal(const ExplorationProblem& problem, const DesignTask& single,
                       const DesignOptions& options) {
  RawDesign design = designFreely(problem, single, options);
  if (problem.u_max.size() == 0 || design.amplitudes.size() == 0) return design;
  return designWithinPeaks(problem, single, options, std::move(design));
}

}  // namespace explore_opt
