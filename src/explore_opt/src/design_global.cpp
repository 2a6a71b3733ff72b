#include <fmt/core.h>

#include <cmath>

#include "checks.hpp"
#include "constants.hpp"
#include "design_tools.hpp"
#include "local_search.hpp"
#include "peak_limits.hpp"
#include "quad_support/interrupt.hpp"
#include "quad_support/linear_algebra.hpp"
#include "relaxation.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRelaxedGap = 1e-9;  // of ½γ_e²; what the polished multipliers cannot improve
                                      // is left to them
constexpr double kLiftedTolerance = 1e-10;
constexpr int kLiftedIterations = 150;
constexpr int kRoundings = 32;
constexpr double kRankTolerance = 1e-4;  // of the largest eigenvalue
constexpr int kPeakRounds = 40;
constexpr std::size_t kPeaksARound = 40;
constexpr double kPeakReserve = 1e-7;  // kept while solving, so that rounding respects the limit

/// The relaxation's answer in the task's coordinates.
struct Relaxed {
  Certificate certificate;
  VectorXd mean;
  quad_support::SymmetricEigen lifted;
  int rank = 0;
};

/// @param stop_above  γ_e that cannot be, see largestCost()
Relaxed relax(const DesignTask& task, const VectorXd& start,
              double stop_above = std::numeric_limits<double>::infinity()) {
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

/// A random vector with the mean and the second moments of the relaxation; several runs one below
/// the other.
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

/// The cheapest of: `fallback`, the leading part of 𝒜, and random vectors with moments 𝒜.
VectorXd roundLifted(const DesignTask& task, const Relaxed& relaxed, const VectorXd& fallback,
                     std::uint64_t seed) {
  VectorXd best = fallback;
  double least =
      fallback.size() > 0 ? task.cost(fallback) : std::numeric_limits<double>::infinity();
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

/// Collects local solutions: the cheapest amplitudes, the best certificate, one iteration each.
class Search {
 public:
  Search(const DesignTask& single, const DesignTask& task, RawDesign& design)
      : single_(single), task_(task), design_(design) {}

  void start(const VectorXd& a) { record(a); }

  void add(const LocalSolution& solution) {
    ++solves_;
    if (solution.status != SolverStatus::kConverged) ++failures_;
    if (solution.root.size() > 0) improveCertificate(single_.certify(solution.root, solution.nu));
    if (solution.amplitudes.size() == 0) return;
    const bool first = design_.amplitudes.size() == 0;
    const double now = design_.amplitudes.norm(), candidate = solution.amplitudes.norm();
    const bool cheaper = first || candidate < now, equal = first || candidate <= now * (1.0 + 1e-9);
    if (cheaper) record(solution.amplitudes);
    if (equal)
      optimal_ = solution.optimal || (!first && optimal_ && candidate >= now * (1.0 - 1e-9));
  }

  void improveCertificate(const Certificate& certificate) {
    if (certificate.bound > design_.certificate.bound) design_.certificate = certificate;
  }

  double gap() const {
    if (design_.amplitudes.size() == 0) return 1.0;
    const double cost = task_.costAt(design_.amplitudes);
    return cost > 0.0 ? 1.0 - design_.certificate.bound / cost : 0.0;
  }
  bool found() const { return design_.amplitudes.size() > 0; }
  const VectorXd& best() const { return design_.amplitudes; }
  bool optimal() const { return optimal_; }
  void tried() { ++starts_; }
  int starts() const { return starts_; }
  int solves() const { return solves_; }
  int failures() const { return failures_; }

 private:
  void record(const VectorXd& a) {
    DesignIteration iteration;
    iteration.gamma_e = task_.costAt(a);
    iteration.step = design_.iterations.empty() || design_.amplitudes.size() == 0
                         ? 0.0
                         : (a - design_.amplitudes).norm();
    iteration.amplitudes = task_.table(a);
    design_.iterations.push_back(iteration);
    design_.amplitudes = a;
  }

  const DesignTask& single_;
  const DesignTask& task_;
  RawDesign& design_;
  bool optimal_ = false;
  int starts_ = 1, solves_ = 0, failures_ = 0;
};

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
    if (!task.peaks.empty() || !search.found()) {
      search.add(polish(task, solver, start, 0.2, nullptr));
      continue;
    }
    const VectorXd seen = glimpse(task, start);
    if (seen.size() == 0 || seen.norm() > (1.0 + 2e-4) * search.best().norm()) continue;
    if (seen.norm() < (1.0 - 2e-4) * search.best().norm() || !same(seen, search.best()))
      search.add(polish(task, solver, seen, 1e-2, nullptr));
  }
}

std::string advice(const RawDesign& design, const DesignTask& task) {
  if (design.rank <= task.runs) return "";
  return fmt::format(
      "; the relaxation has rank {}, so one experiment may not reach the bound: \"experiments\": "
      "{} "
      "meets it as root mean square per run",
      design.rank, design.rank);
}

void conclude(const Search& search, const DesignOptions& options, const DesignTask& task,
              RawDesign& design) {
  const std::string solves = search.failures() == 0
                                 ? ""
                                 : fmt::format(" ({} of {} local solves did not converge)",
                                               search.failures(), search.solves());
  if (search.gap() <= options.gap_tolerance) {
    design.status = DesignStatus::kSolved;
    design.message = fmt::format("globally optimal to {:.2g} (certified)", search.gap());
  } else if (search.optimal()) {
    design.status = DesignStatus::kSolved;
    design.message =
        fmt::format("best local optimum of {} starts; certified within {:.2g} of the global one{}",
                    search.starts(), search.gap(), advice(design, task));
  } else {
    design.status = DesignStatus::kReducedAccuracy;
    design.message =
        fmt::format("feasible, certified within {:.2g} of the optimum, but not a KKT point{}{}",
                    search.gap(), solves, advice(design, task));
  }
}

/// Without peak limits.
RawDesign designFreely(const ExplorationProblem& problem, const DesignTask& single,
                       const DesignOptions& options) {
  RawDesign design;
  const auto start = cheapestSimpleDirection(single, options.seed);
  if (!start) {
    design.status = DesignStatus::kNotExciting;
    design.message = reasonNothingExcites(problem, single);
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
  conclude(search, options, task, design);
  return design;
}

DesignTask withReserve(const DesignTask& task) {
  DesignTask reserved = task;
  for (PeakConstraint& peak : reserved.peaks) peak.limit *= 1.0 - kPeakReserve;
  return reserved;
}

/// With the peaks of `task`: from the best amplitudes so far and from a few others.
RawDesign designWithin(const DesignTask& task, const DesignOptions& options, const VectorXd& from,
                       double largest) {
  RawDesign design;
  const DesignTask reserved = withReserve(task);
  Search search(task, reserved, design);
  const Relaxed relaxed = relax(task, from, largest);
  search.improveCertificate(relaxed.certificate);
  design.rank = relaxed.rank;
  design.peaks = task.peaks;
  if (design.certificate.bound > largest) {
    design.status = DesignStatus::kInfeasible;
    design.message = fmt::format(
        "u_max is too small: the condition needs gamma_e >= {:.6g} (certified), signals within "
        "u_max have at most {:.6g}",
        design.certificate.bound, largest);
    return design;
  }
  IpoptSolver solver(kLiftedTolerance, kLiftedIterations);
  const VectorXd rounded = roundLifted(reserved, relaxed, from, options.seed);
  search.add(polish(reserved, solver, rounded, 1e-3, nullptr));
  if (search.gap() > options.gap_tolerance)
    search.add(polish(reserved, solver, from, 1e-3, nullptr));
  searchOn(search, reserved, &relaxed, options, solver);
  if (design.amplitudes.size() > 0) {
    conclude(search, options, reserved, design);
  } else {
    design.status = DesignStatus::kNumericalError;
    design.message = fmt::format(
        "no amplitudes within u_max found in {} starts; not proven that there are none (gamma_e >= "
        "{:.6g} is). Raise u_max or add lines",
        search.solves(), design.certificate.bound);
  }
  return design;
}

}  // namespace

RawDesign designGlobal(const ExplorationProblem& problem, const DesignTask& single,
                       const DesignOptions& options) {
  RawDesign design = designFreely(problem, single, options);
  if (problem.u_max.size() == 0 || design.amplitudes.size() == 0) return design;
  DesignTask task = single;
  const double largest = largestCost(problem, single);
  VectorXd from = design.amplitudes;
  for (int round = 0; round < kPeakRounds; ++round) {
    if (design.amplitudes.size() > 0) from = design.amplitudes;
    const MatrixXd table = task.table(from);
    if (design.amplitudes.size() > 0 && peakRatio(problem, table) <= 1.0) return design;
    const auto peaks = bindingPeaks(problem, task, table, 0.02, kPeaksARound);
    if (peaks.empty()) return design;  // all known already: as it stands
    task.peaks.insert(task.peaks.end(), peaks.begin(), peaks.end());
    std::vector<DesignIteration> history = std::move(design.iterations);
    design = designWithin(task, options, from, largest);
    history.insert(history.end(), design.iterations.begin(), design.iterations.end());
    design.iterations = std::move(history);
    if (design.status == DesignStatus::kInfeasible) return design;
    if (design.amplitudes.size() == 0) return design;
  }
  design.amplitudes.resize(0);
  design.status = DesignStatus::kIterationLimit;
  design.message =
      fmt::format("u_max is exceeded between the {} instants considered so far", task.peaks.size());
  return design;
}

}  // namespace explore_opt
