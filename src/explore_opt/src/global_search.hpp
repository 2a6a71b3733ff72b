/// What both parts of the global method share: the relaxation and starts drawn from it, and the
/// record of a search.
#pragma once

#include <limits>
#include <string>

#include "constants.hpp"
#include "design_tools.hpp"
#include "local_search.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {

constexpr double kLiftedTolerance = 1e-10;  // of Ipopt, in scaled coordinates
constexpr int kLiftedIterations = 150;
constexpr double kGlimpsed = 2e-4;  // of the cost: twice what glimpse() is accurate to

/// The relaxation's answer in the task's coordinates.
struct Relaxed {
  Certificate certificate;
  Eigen::VectorXd mean;
  quad_support::SymmetricEigen lifted;
  int rank = 0;
};

/// @param stop_above  γ_e that cannot be, see largestCost()
Relaxed relax(const DesignTask& task, const Eigen::VectorXd& start, double stop_above = kInfinity);

/// A random vector with the mean and the second moments of the relaxation; several runs one below
/// the other.
Eigen::VectorXd drawn(const DesignTask& task, const Relaxed& relaxed, std::uint64_t seed,
                      std::uint64_t index);

/// The cheapest of: `fallback`, the leading part of 𝒜, and random vectors with moments 𝒜.
Eigen::VectorXd roundLifted(const DesignTask& task, const Relaxed& relaxed,
                            const Eigen::VectorXd& fallback, std::uint64_t seed);

/// Collects local solutions: the cheapest amplitudes, the best certificate, one iteration each.
class Search {
 public:
  Search(const DesignTask& single, const DesignTask& task, RawDesign& design)
      : single_(single), task_(task), design_(design) {}

  void start(const Eigen::VectorXd& a) { record(a); }

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

  /// A start that led nowhere.
  void miss() { ++solves_, ++failures_; }

  void improveCertificate(const Certificate& certificate) {
    if (certificate.bound > design_.certificate.bound) design_.certificate = certificate;
  }

  double gap() const {
    if (design_.amplitudes.size() == 0) return 1.0;
    const double cost = task_.costAt(design_.amplitudes);
    return cost > 0.0 ? 1.0 - design_.certificate.bound / cost : 0.0;
  }
  bool found() const { return design_.amplitudes.size() > 0; }
  const Eigen::VectorXd& best() const { return design_.amplitudes; }
  bool optimal() const { return optimal_; }
  void tried() { ++starts_; }
  int starts() const { return starts_; }
  int solves() const { return solves_; }
  int failures() const { return failures_; }

 private:
  void record(const Eigen::VectorXd& a) {
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

/// Status and message of a search that has found amplitudes.
/// @param advice  said where the gap is open
void conclude(const Search& search, const DesignOptions& options, const std::string& advice,
              RawDesign& design);

/// "globally optimal to 1e-12 (certified)"; rounding may put a gap below zero.
std::string globallyOptimal(double gap);

}  // namespace explore_opt
