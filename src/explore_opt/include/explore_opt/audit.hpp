/// A second opinion on a design, from the raw data of the problem alone.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// What a design claims, as its file has it.
struct DesignClaims {
  Eigen::MatrixXd amplitudes;  ///< carriers x n_u; several experiments one below the other
  double gamma_e = 0.0, lower_bound = 0.0, gap = 0.0;
  std::optional<double> lambda_min;
  std::string status;               ///< as toString(DesignStatus); empty: not claimed
  Eigen::MatrixXd certificate;      ///< Z in coordinates normalised by D_des^{-1/2}; may be empty
  Eigen::MatrixXd multiplier;       ///< M in raw coordinates; may be empty
  Eigen::MatrixXd multiplier_root;  ///< Y, M = Y Yᵀ, taken instead if there is one
  struct Peak {
    int sample = 0, input = -1;
    double value = 0.0;
  };
  std::vector<Peak> peak_multipliers;
};

/// One thing that was recomputed.
struct AuditCheck {
  std::string name;  ///< as listed at audit()
  bool passed = false;
  std::string finding;  ///< what was computed and what was claimed
};

struct AuditReport {
  std::vector<AuditCheck> checks;
  double lambda_min = 0.0;  ///< largest ρ with information ⪰ ρ γ_w D_des
  double gamma_e = 0.0;
  double lower_bound = 0.0;  ///< what the multiplier proves
  double gap = 0.0;
  double peak = 0.0;        ///< max_k ‖u_k‖
  double peak_ratio = 0.0;  ///< with u_max: the largest ‖u_k‖/u_max or |u_kj|/u_max,j

  bool passed() const;
};

/// What audit() grants, each relative to what is judged.
struct AuditTolerance {
  static constexpr double kInformation = 1e-9;
  static constexpr double kCost = 1e-9;
  static constexpr double kGap = 1e-9;
  static constexpr double kBound = 1e-6;
  static constexpr double kPeak = 1e-6;
  /// What is only said twice must agree to what the bound itself is judged to. Products of roots in
  /// doubles are off by 1e-13 at most.
  static constexpr double kSaidTwice = 1e-6;
};

/// Recomputes everything by sample-by-sample simulation in long double and one eigenvalue problem
/// each for feasibility and bound. No code is shared with the solvers, nothing they say is
/// believed:
///
///   feasible     Σ_k φ_k φ_kᵀ [⊗ I] ⪰ γ_w D_des (1 - 1e-9) on the unknown entries
///   cost         γ_e of the amplitudes equals the claim to 1e-9
///   lower_bound  ½γ_e² - tr M₊(Q [⊗ I] - γ_w D_des) + Σ ½ν_k (‖u_k‖² - u_max²) has a least value
///                over all amplitudes, for M₊ = Y Yᵀ or the positive part of the multiplier, scaled
///                as well as possible; the claim must not exceed it by more than 1e-6 (relative)
///   gap          is (γ_e - lower_bound)/γ_e, and not below -1e-9
///   peak         no input above u_max (1 + 1e-6), where there is a limit
///   experiments  as many as the problem asks for
///   lambda_min   the claim is the computed one to 1e-6, where there is a claim
///   status       one that comes with an answer, where there is a claim
///   multiplier, certificate   what the bound was proven with, up to a factor, where they are given
///                (the certificate for D_des that is not singular and without known entries)
/// @throws quad_support::DataError for claims whose shapes do not fit the problem
AuditReport audit(const ExplorationProblem& problem, const DesignClaims& claims);

/// Reads the answer of `explore_opt design`.
/// @throws quad_support::ConfigError: no JSON, missing keys, wrong types or shapes; no amplitudes
DesignClaims claimsFromJson(const std::string& text, const std::string& source,
                            const ExplorationProblem& problem);

nlohmann::ordered_json auditToJson(const AuditReport& report);

}  // namespace explore_opt
