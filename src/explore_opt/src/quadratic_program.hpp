/// min ½‖a‖² s.t. N(a) = Σ a_a a_b S_ab ⪰ R, in coordinates where numbers are of the order of one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore_opt/predicted_response.hpp"

namespace explore_opt {

/// The design problem after a change of coordinates a = s â, N̂ = Cᵀ N C (which keeps the order of
/// matrices).
///
/// C makes N̂ of the reference amplitudes ã have a unit diagonal (integrators spread it over six
/// decades) and turns N̂(ã) - R̂ diagonal, largest entry first, so that the direction in which the
/// constraint is active comes last.
class QuadraticProgram {
 public:
  /// @param reference  ã with N(ã) ≻ 0, scaled to the boundary λ_min(N(ã)) = γ_w
  QuadraticProgram(const PredictedResponse& response, double gamma_w,
                   const Eigen::VectorXd& reference);

  int numAmplitudes() const { return p_; }
  int size() const { return static_cast<int>(R_.rows()); }
  const Eigen::MatrixXd& rightSide() const { return R_; }

  const Eigen::MatrixXd& S(int a, int b) const { return S_[static_cast<std::size_t>(a * p_ + b)]; }
  Eigen::MatrixXd N(const Eigen::VectorXd& a) const;
  Eigen::MatrixXd derivative(const Eigen::VectorXd& a, int i) const;  ///< ∂N/∂a_i = 2 Σ_b a_b S_ib
  Eigen::MatrixXd H(const Eigen::MatrixXd& Z) const;                  ///< tr(Z S_ab), Z symmetric

  Eigen::VectorXd toScaled(const Eigen::VectorXd& amplitudes) const { return amplitudes / scale_; }
  Eigen::VectorXd toAmplitudes(const Eigen::VectorXd& a) const { return scale_ * a; }
  /// Multiplier of the original constraint
  Eigen::MatrixXd toCertificate(const Eigen::MatrixXd& Z) const;
  Eigen::MatrixXd fromCertificate(const Eigen::MatrixXd& Z) const;  ///< and back

 private:
  int p_;
  double scale_;
  Eigen::MatrixXd C_, R_;
  std::vector<Eigen::MatrixXd> S_;
};

}  // namespace explore_opt
