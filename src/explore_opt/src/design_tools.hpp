/// What both design methods share: scaling to the boundary, directions to start from, certificates,
/// the last checks.
#pragma once

#include <optional>

#include "explore_opt/exploration_design.hpp"
#include "explore_opt/predicted_response.hpp"

namespace explore_opt {

/// A multiplier and the bound it proves.
struct Certificate {
  Eigen::MatrixXd Z;
  double bound = 0.0;  ///< 0 proves nothing
};

/// What a design method hands over; amplitudes feasible or empty.
struct RawDesign {
  DesignStatus status = DesignStatus::kNumericalError;
  std::string message;
  Eigen::VectorXd amplitudes;
  Certificate certificate;
  std::vector<DesignIteration> iterations;
  double inner_gap = 0.0;
};

/// The response and γ_w: all a design method needs to know of a problem.
struct DesignTask {
  PredictedResponse response;
  double gamma_w = 0.0;
  int num_inputs = 1;

  /// λ_min(N)/λ_max(N) with N scaled to a unit diagonal is above 1e-9.
  bool excites(const Eigen::VectorXd& direction) const;
  /// sqrt(γ_w ‖d‖²/λ_min(N(d))), infinite if `direction` does not excite.
  double cost(const Eigen::VectorXd& direction) const;
  /// The multiple of an exciting direction with λ_min(N) = γ_w, from above by rounding.
  Eigen::VectorXd onBoundary(const Eigen::VectorXd& direction) const;
  /// sqrt(γ_w tr Z/λ_max(H(Z))) of the positive part of Z, less what rounding may have added.
  Certificate certify(const Eigen::MatrixXd& Z) const;
  /// Components of a as carriers x n_u.
  Eigen::MatrixXd table(const Eigen::VectorXd& a) const;
  Eigen::VectorXd components(const Eigen::MatrixXd& table) const;
};

/// The cheapest of simple directions (equal, single, random signs, normal), scaled to the boundary;
/// none if none of them excites. A polynomial that is zero at a random point is zero everywhere, so
/// none means no direction does.
std::optional<Eigen::VectorXd> cheapestSimpleDirection(const DesignTask& task, std::uint64_t seed);

/// Component-wise normal random direction number `index`.
Eigen::VectorXd randomDirection(const DesignTask& task, std::uint64_t seed, std::uint64_t index);

RawDesign designGlobal(const DesignTask& task, const DesignOptions& options);
RawDesign designByMajorisation(const DesignTask& task, const DesignOptions& options);

}  // namespace explore_opt
