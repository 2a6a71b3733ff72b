/// Amplitudes of least norm that guarantee the desired closeness, with a proof of how good they
/// are; Eq. (1.13).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// kGlobal: certified lower bound from the convex dual, amplitudes from a nonlinear program started
/// at its solution. kMm: the paper's algorithm, relaxations L1, L2 re-linearised at their own
/// solution until nothing changes.
enum class DesignMethod { kGlobal, kMm };

std::string toString(DesignMethod method);  ///< "global", "mm"
/// @throws quad_support::DataError naming the choices
DesignMethod methodFromString(const std::string& text);

enum class DesignStatus {
  /// Feasible and converged (global: gap within tolerance, or the best of all starts is a KKT
  /// point)
  kSolved,
  /// Feasible, but the solver stopped early or the KKT conditions are met only roughly
  kReducedAccuracy,
  /// No amplitudes satisfy the constraint
  kInfeasible,
  /// No combination of these carriers excites all parameters: change lines, not amplitudes
  kNotExciting,
  /// Feasible, but the iterations ran out
  kIterationLimit,
  /// No usable amplitudes
  kNumericalError,
};

std::string toString(DesignStatus status);  ///< "solved", "reduced_accuracy", ...

struct DesignOptions {
  DesignMethod method = DesignMethod::kGlobal;
  /// global: no further starts once the certified relative gap is below
  double gap_tolerance = 1e-5;
  /// global: starts beside the dual's, used only while the gap is larger
  int random_starts = 8;
  /// Of those starts, and of mm's start if none is given
  std::uint64_t seed = 1;
  /// mm: candidate ã of any size, p entries, component i n_u + j; empty: a default
  Eigen::VectorXd initial_amplitudes;
  /// mm: stop when γ_e changes by less than this part of itself and ...
  double cost_tolerance = 1e-9;
  /// mm: ... ‖Δa‖ is below this part of ‖a‖
  double step_tolerance = 1e-5;
  /// mm: re-linearisations
  int max_iterations = 1000;
  /// mm: duality gap n μ of the last relaxations, part of ½γ_e²
  double inner_gap = 1e-9;
  /// mm: lengthen each step while that lowers the cost; false: as in the paper
  bool extrapolate = true;
};

/// One step towards the amplitudes: what Figures 2.5, 2.6 and 2.7 plot.
struct DesignIteration {
  double gamma_e = 0.0;    ///< norm of the amplitudes, feasible
  double step = 0.0;       ///< ‖Δa‖ to the iterate before (0 for the first)
  double inner_gap = 0.0;  ///< mm: n μ, duality gap of ½‖a‖² in the relaxation just solved
  Eigen::MatrixXd amplitudes;  ///< carriers x n_u
};

struct DesignResult {
  DesignStatus status = DesignStatus::kNumericalError;
  DesignMethod method = DesignMethod::kGlobal;
  /// One line: why this status
  std::string message;
  /// α*, carriers x n_u; both phases: cosines, then sines. The largest |entry| is positive
  Eigen::MatrixXd amplitudes;
  /// ‖α*‖
  double gamma_e = std::numeric_limits<double>::quiet_NaN();
  /// No amplitudes with smaller norm satisfy the constraint
  double lower_bound = 0.0;
  /// (γ_e - lower_bound)/γ_e
  double gap = std::numeric_limits<double>::quiet_NaN();
  /// λ_min(N(α*))/γ_w, recomputed; feasible if >= 1
  double lambda_min = std::numeric_limits<double>::quiet_NaN();
  /// Z ⪰ 0, n x n: lower_bound = sqrt(γ_w tr Z/λ_max(H(Z)))
  Eigen::MatrixXd certificate;
  std::vector<DesignIteration> iterations;
  /// mm: n μ of the last relaxation
  double inner_gap = 0.0;
  /// Wall time
  double seconds = 0.0;

  bool feasible() const { return amplitudes.size() > 0; }
};

/// Solves   min ‖a‖   s.t.   N(a) ⪰ γ_w I   (see predicted_response.hpp).
/// A numerical outcome is a status, not an exception.
/// @throws quad_support::DataError if the problem or an option is not valid
DesignResult designExploration(const ExplorationProblem& problem,
                               const DesignOptions& options = {});

/// The bound any Z ⪰ 0, Z ≠ 0 gives: γ_e >= sqrt(γ_w tr Z / λ_max(H(Z))). One eigenvalue of a p x p
/// matrix.
double lowerBound(const ExplorationProblem& problem, const Eigen::MatrixXd& certificate);

/// Cost of a direction after scaling it to the boundary: sqrt(γ_w ‖d‖²/λ_min(N(d))).
/// Infinite if the direction does not excite all parameters.
/// @param amplitudes  carriers x n_u
double scaledCost(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes);

}  // namespace explore_opt
