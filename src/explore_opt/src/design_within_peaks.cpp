#include "design_within_peaks.hpp"

#include <fmt/core.h>

#include <cmath>

#include "global_search.hpp"
#include "peak_limits.hpp"
#include "quad_support/interrupt.hpp"

namespace explore_opt {
namespace {

using Eigen::VectorXd;

constexpr int kPeakRounds = 40;
constexpr std::size_t kPeaksARound = 40;
constexpr double kPeakMargin = 0.02;   // below the limit, from which on an instant is considered
constexpr double kOutside = 1.001;     // times a boundary point: strictly feasible
constexpr double kPeakReserve = 1e-7;  // kept while solving, so that rounding respects the limit

/// The task with the instants met so far, as they are for certificates and with the reserve for
/// solvers, and local searches that respect all instants.
class PeakSearch {
 public:
  PeakSearch(const ExplorationProblem& problem, const DesignTask& single,
             const DesignOptions& options, RawDesign& design)
      : problem_(problem),
        options_(options),
        design_(design),
        task_(single),
        reserved_(single),
        search_(task_, reserved_, design),
        solver_(kLiftedTolerance, kLiftedIterations) {}

  /// Amplitudes within the limit at all instants that `start`, a boundary point, leads to: inside
  /// by the peaks, down by the barrier, and polished where that may give something cheaper.
  void settle(const VectorXd& start) {
    if (!(start.norm() > 0.0)) return search_.miss();
    const VectorXd inside = enter(start);
    VectorXd a = inside.size() > 0 ? descendFrom(inside) : inside;
    if (a.size() == 0) return search_.miss();
    if (search_.found() && a.norm() > (1.0 + kGlimpsed) * search_.best().norm()) return;
    for (int round = 0; round < kPeakRounds; ++round) {
      const LocalSolution solution = polish(reserved_, solver_, a, 1e-6, nullptr);
      if (solution.amplitudes.size() == 0) return search_.miss();
      if (ratioOf(solution.amplitudes) <= 1.0) return search_.add(solution);
      certify(solution);
      if (!addPeaks(solution.amplitudes)) return search_.miss();
      a = descendFrom(inside);
      if (a.size() == 0) return search_.miss();
    }
    search_.miss();
  }

  /// The bound with the instants met so far.
  Relaxed relaxed(const VectorXd& reference, double largest) {
    Relaxed relaxed = relax(task_, reference, largest);
    search_.improveCertificate(relaxed.certificate);
    design_.rank = relaxed.rank;
    return relaxed;
  }

  /// From the relaxation's solution and random directions, until the gap is closed.
  void searchOn(const Relaxed* relaxed, const VectorXd& fallback) {
    if (relaxed != nullptr && open()) {
      search_.tried();
      settle(roundLifted(reserved_, *relaxed, fallback, options_.seed));
    }
    for (int i = 0; i < options_.random_starts && open(); ++i) {
      const auto index = static_cast<std::uint64_t>(i);
      const VectorXd direction = relaxed != nullptr && i % 2 == 0
                                     ? drawn(reserved_, *relaxed, options_.seed, index)
                                     : randomDirection(reserved_, options_.seed, index);
      if (!std::isfinite(reserved_.cost(direction))) continue;
      search_.tried();
      settle(reserved_.onBoundary(direction));
    }
  }

  bool open() const { return search_.gap() > options_.gap_tolerance; }
  const std::vector<PeakConstraint>& peaks() const { return task_.peaks; }

  void finish() {
    design_.peaks = task_.peaks;
    if (search_.found()) return conclude(search_, options_, "", design_);
    design_.status = DesignStatus::kNumericalError;
    const std::string least =
        std::isfinite(least_peak_)
            ? fmt::format(", the least peak of those found is {:.6g} u_max", least_peak_)
            : "";
    design_.message = fmt::format(
        "no amplitudes within u_max found in {} starts{}; not proven that there are none (gamma_e "
        ">= {:.6g} is). Raise u_max or add lines",
        search_.starts(), least, design_.certificate.bound);
  }

 private:
  double ratioOf(const VectorXd& a) const { return peakRatio(problem_, task_.table(a)); }

  /// Instants near or above the limit. @returns whether there were new ones
  bool addPeaks(const VectorXd& a) {
    const auto peaks = bindingPeaks(problem_, task_, task_.table(a), kPeakMargin, kPeaksARound);
    for (PeakConstraint peak : peaks) {
      task_.peaks.push_back(peak);
      peak.limit *= 1.0 - kPeakReserve;
      reserved_.peaks.push_back(peak);
    }
    return !peaks.empty();
  }

  void certify(const LocalSolution& solution) {
    if (solution.root.size() > 0)
      search_.improveCertificate(task_.certify(solution.root, solution.nu));
  }

  /// A strictly feasible point, within the limit at all instants, down the peaks from `a`; empty if
  /// their local minimum is above it.
  VectorXd enter(const VectorXd& start) {
    VectorXd a = kOutside * start;
    for (int round = 0; round < kPeakRounds; ++round) {
      quad_support::throwIfInterrupted();
      const bool more = addPeaks(a);
      if (round > 0 && !more) break;
      a = towardsLeastPeak(reserved_, a);
      const VectorXd nearest = a.size() > 0 ? reserved_.onBoundary(a) : a;
      if (nearest.size() == 0) return {};
      least_peak_ = std::min(least_peak_, ratioOf(nearest));
      if (ratioOf(a) <= 1.0 - kPeakReserve) return a;
    }
    return {};
  }

  /// A local minimum, nearly, of the cost within the limit at all instants; empty if the barrier
  /// fails.
  VectorXd descendFrom(const VectorXd& inside) {
    for (int round = 0; round < kPeakRounds; ++round) {
      quad_support::throwIfInterrupted();
      const VectorXd a = glimpse(reserved_, inside);
      if (a.size() == 0 || ratioOf(a) <= 1.0) return a;
      if (!addPeaks(a)) break;
    }
    return {};
  }

  const ExplorationProblem& problem_;
  const DesignOptions& options_;
  RawDesign& design_;
  DesignTask task_, reserved_;
  Search search_;
  IpoptSolver solver_;
  double least_peak_ = kInfinity;
};

bool isTooSmall(RawDesign& design, double largest) {
  if (!(design.certificate.bound > largest)) return false;
  design.status = DesignStatus::kInfeasible;
  design.amplitudes.resize(0);
  design.message = fmt::format(
      "u_max is too small: the condition needs gamma_e >= {:.6g} (certified), signals within "
      "u_max have at most {:.6g}",
      design.certificate.bound, largest);
  return true;
}

}  // namespace

RawDesign designWithinPeaks(const ExplorationProblem& problem, const DesignTask& single,
                            const DesignOptions& options, RawDesign free) {
  if (peakRatio(problem, single.table(free.amplitudes)) <= 1.0) return free;
  const double largest = largestCost(problem, single);
  if (isTooSmall(free, largest)) return free;
  const VectorXd from = free.amplitudes;
  RawDesign design = std::move(free);
  design.amplitudes.resize(0);
  PeakSearch search(problem, single, options, design);
  search.settle(from);
  std::optional<Relaxed> relaxed;
  if (search.open() && isSmallEnough(single) && from.norm() > 0.0) {
    relaxed = search.relaxed(from, largest);
    design.peaks = search.peaks();
    if (isTooSmall(design, largest)) return design;
  }
  const std::size_t instants = search.peaks().size();
  search.searchOn(relaxed ? &*relaxed : nullptr, from);
  if (relaxed && search.open() && search.peaks().size() > instants) search.relaxed(from, largest);
  search.finish();
  return design;
}

}  // namespace explore_opt
