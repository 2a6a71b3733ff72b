/// What both design methods share: scaling to the boundary, directions to start from, certificates,
/// the last checks.
#pragma once

#include <optional>

#include "explore_opt/exploration_design.hpp"
#include "explore_opt/predicted_response.hpp"
#include "quadratic_program.hpp"

namespace explore_opt {

/// A multiplier Z = Y Yᵀ (with those of the peak limits, of ½(‖Q_k a‖²/limit² - 1)) and the bound
/// it proves.
struct Certificate {
  Eigen::MatrixXd root;  ///< Y
  double bound = 0.0;    ///< 0 proves nothing
  Eigen::VectorXd nu;
};

/// What a design method hands over; amplitudes feasible or empty.
struct RawDesign {
  DesignStatus status = DesignStatus::kNumericalError;
  std::string message;
  Eigen::VectorXd amplitudes;
  Certificate certificate;
  std::vector<DesignIteration> iterations;
  double inner_gap = 0.0;
  int rank = 0;                       ///< of the relaxation's solution; 0: not computed
  std::vector<PeakConstraint> peaks;  ///< those the certificate's ν belong to
};

/// a = centre + shape b: coordinates b in which the cost is γ_e² = ‖b‖² + floor.
struct AmplitudeMap {
  Eigen::VectorXd centre;  ///< empty: zero
  Eigen::MatrixXd shape;   ///< empty: the identity
  double floor = 0.0;

  Eigen::VectorXd toAmplitudes(const Eigen::VectorXd& b) const;
  Eigen::VectorXd toNormalised(const Eigen::VectorXd& a) const;
};

/// Response and γ_w: all a design method needs to know of a problem. Amplitudes here are the b of
/// `map`; where x_0 = 0 everything scales, and a direction is as good as a point.
struct DesignTask {
  PredictedResponse response;
  double gamma_w = 0.0;
  int num_inputs = 1;
  AmplitudeMap map;
  Eigen::MatrixXd required;           ///< N ⪰ γ_w required is asked for; empty: the identity
  std::vector<PeakConstraint> peaks;  ///< those taken into account
  int runs = 1;                       ///< amplitudes of so many runs one after the other

  /// λ_min(N)/λ_max(N) with N scaled to a unit diagonal is above 1e-14: what doubles resolve.
  bool excites(const Eigen::VectorXd& direction) const;
  /// Largest ρ with N(b) ⪰ ρ γ_w required.
  double informationRatio(const Eigen::VectorXd& b) const;
  /// γ_e of the direction's point on the boundary, infinite if there is none.
  double cost(const Eigen::VectorXd& direction) const;
  /// The least multiple of a direction from which on λ_min(N) >= γ_w, from above by rounding; empty
  /// if there is none.
  Eigen::VectorXd onBoundary(const Eigen::VectorXd& direction) const;
  /// γ_e of a point.
  double costAt(const Eigen::VectorXd& b) const { return std::sqrt(b.squaredNorm() + map.floor); }
  /// No point of lower cost satisfies the constraints: the least value over a of the Lagrangian
  /// with Y Yᵀ and the positive part of ν, scaled as well as possible, less what rounding may have
  /// added.
  Certificate certify(const Eigen::MatrixXd& root, const Eigen::VectorXd& nu = {}) const;
  /// Amplitudes of a point as carriers x n_u; several runs one below the other.
  Eigen::MatrixXd table(const Eigen::VectorXd& b) const;
  Eigen::VectorXd components(const Eigen::MatrixXd& table) const;
  /// The same experiment r times with amplitudes of their own: b = [b_1; ...; b_r], the mean of
  /// N(√r b_i), γ_e = ‖b‖ the root mean square.
  DesignTask replicated(int r) const;
};

/// @throws quad_support::DataError, ResponseOverflow
DesignTask taskOf(const ExplorationProblem& problem);

/// The cheapest of simple directions (equal, single, random signs, normal), scaled to the boundary;
/// none if none of them reaches it. A polynomial that is zero at a random point is zero everywhere,
/// so without x_0 none means no direction does.
std::optional<Eigen::VectorXd> cheapestSimpleDirection(const DesignTask& task, std::uint64_t seed);

/// Component-wise normal random direction number `index`.
Eigen::VectorXd randomDirection(const DesignTask& task, std::uint64_t seed, std::uint64_t index);

/// The relaxation has few enough unknowns: beyond 1200 a Newton step takes seconds.
bool isSmallEnough(const DesignTask& task);

/// Says why no amplitudes excite, in terms of the problem: modes out of the inputs' reach, too few
/// lines or samples, growth. A start far out is no reason, for large amplitudes outdo it: it only
/// leaves doubles no digits, which is a numerical error.
void refuseToExcite(const ExplorationProblem& problem, const DesignTask& task, RawDesign& design);

RawDesign designGlobal(const ExplorationProblem& problem, const DesignTask& task,
                       const DesignOptions& options);
RawDesign designByMajorisation(const ExplorationProblem& problem, const DesignTask& task,
                               const DesignOptions& options);

}  // namespace explore_opt
