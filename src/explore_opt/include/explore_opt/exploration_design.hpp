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
  /// Feasible, but the solver stopped early, the KKT conditions are met only roughly, or rounding
  /// in growing modes leaves less certified
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
  int random_starts = 24;
  /// Of those starts, and of mm's start if none is given
  std::uint64_t seed = 1;
  /// mm: candidate ã of any size, p entries, component i n_u + j (several experiments one after the
  /// other); empty: a default
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

/// Multiplier of ½(‖u_k‖² - u_max²) (input -1), or of one input's ½(u_kj² - u_max,j²).
struct PeakMultiplier {
  int sample = 0;
  int input = -1;
  double value = 0.0;
};

struct DesignResult {
  DesignStatus status = DesignStatus::kNumericalError;
  DesignMethod method = DesignMethod::kGlobal;
  /// One line: why this status
  std::string message;
  /// α*, carriers x n_u; both phases: cosines, then sines; several experiments one below the other.
  /// From rest the largest |entry| is positive
  Eigen::MatrixXd amplitudes;
  /// ‖α*‖, or what ExplorationProblem::cost and ::experiments say
  double gamma_e = std::numeric_limits<double>::quiet_NaN();
  /// No amplitudes with smaller norm satisfy the constraint
  double lower_bound = 0.0;
  /// (γ_e - lower_bound)/γ_e
  double gap = std::numeric_limits<double>::quiet_NaN();
  /// Largest ρ with P_θ⁻¹ ⪰ ρ γ_w D_des for the answer, recomputed; feasible if >= 1
  double lambda_min = std::numeric_limits<double>::quiet_NaN();
  /// Z ⪰ 0, n x n. From rest, D_des ≻ 0, cost on the signal and no u_max:
  /// lower_bound = sqrt(γ_w tr Z/λ_max(H(Z)))
  Eigen::MatrixXd certificate;
  /// The same in the raw coordinates, M = E W Z W Eᵀ, for every problem: no amplitudes cost less
  /// than lower_bound, because ½ lower_bound² is the least value over a of
  /// ½γ_e(a)² - tr M (Q(a)[⊗ I] - γ_w D_des) + Σ ½ν_k (‖u_k(a)‖² - u_max²).
  /// Size n_φ (D ⊗ I, nothing known) or n_φ n_x.
  Eigen::MatrixXd multiplier;
  /// Y with M = Y Yᵀ: where responses grow over many decades M has too few digits to prove the
  /// bound, Y has them
  Eigen::MatrixXd multiplier_root;
  /// ν_k > 0
  std::vector<PeakMultiplier> peak_multipliers;
  /// Rank of the relaxation's solution 𝒜 (eigenvalues above 1e-4 of the largest); 1: the bound is
  /// met by one experiment. 0: not computed
  int relaxation_rank = 0;
  /// With u_max: the largest of the predicted ‖u_k‖/u_max (or |u_kj|/u_max,j); at most 1
  double peak = std::numeric_limits<double>::quiet_NaN();
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

/// The bound any Z ⪰ 0, Z ≠ 0 gives: γ_e >= sqrt(γ_w tr Z / λ_max(H(Z))), one eigenvalue of a p x p
/// matrix; from x_0 ≠ 0 the best scaling of Z. Not with u_max: @throws quad_support::DataError.
double lowerBound(const ExplorationProblem& problem, const Eigen::MatrixXd& certificate);

/// Cost of a direction after scaling it to the boundary: sqrt(γ_w ‖d‖²/λ_min(N(d))).
/// Infinite if the direction does not excite all parameters.
/// @param amplitudes  carriers x n_u
double scaledCost(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes);

}  // namespace explore_opt
