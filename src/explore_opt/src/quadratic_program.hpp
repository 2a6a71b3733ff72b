/// min ½‖a‖² s.t. N(a) ⪰ R and peak limits, in coordinates where numbers are of the order of one.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "explore_opt/predicted_response.hpp"

namespace explore_opt {

/// ‖rows a + offset‖ <= limit: the predicted input (or one of its components) at one instant.
struct PeakConstraint {
  int sample = 0;
  int input = -1;        ///< -1: the norm of all inputs
  Eigen::MatrixXd rows;  ///< m x p
  Eigen::VectorXd offset;
  double limit = 0.0;

  /// (limit² - ‖rows a + offset‖²)/limit²: 1 - (peak/limit)²
  double room(const Eigen::Ref<const Eigen::VectorXd>& a) const {
    double square = 0.0;
    for (Eigen::Index r = 0; r < rows.rows(); ++r) square += std::pow(value(r, a), 2);
    return 1.0 - square / (limit * limit);
  }
  /// Component `r` of rows a + offset
  double value(Eigen::Index r, const Eigen::Ref<const Eigen::VectorXd>& a) const {
    return rows.row(r).dot(a) + offset(r);
  }
};

/// The design problem after a change of coordinates a = s â, N̂ = Cᵀ N C (which keeps the order of
/// matrices). N(a) = F(a)ᵀ F(a) = S_00 + 2 Σ a_i S_0i + Σ a_i a_j S_ij, F(a) = F_0 + Σ a_i F_i,
/// S_ij the symmetric part of F_iᵀ F_j; what bears a 0 only if x_0 is not zero.
///
/// C makes N̂ of the reference amplitudes ã the identity (integrators and unstable modes spread it
/// over many decades) and turns R̂ diagonal, smallest entry first, so that the direction in which
/// the constraint is active comes last.
class QuadraticProgram {
 public:
  /// @param reference  ã with N(ã) ≻ 0, scaled to the boundary λ_min(N(ã)) = γ_w
  QuadraticProgram(const PredictedResponse& response, double gamma_w,
                   const Eigen::VectorXd& reference, const std::vector<PeakConstraint>& peaks = {});

  int numAmplitudes() const { return p_; }
  int size() const { return static_cast<int>(R_.rows()); }
  bool homogeneous() const { return S_offset_.empty(); }
  const Eigen::MatrixXd& rightSide() const { return R_; }

  const Eigen::MatrixXd& S(int a, int b) const { return S_[index(a, b)]; }
  const Eigen::MatrixXd& S_00() const { return S_00_; }
  const Eigen::MatrixXd& S_0(int a) const { return S_offset_[static_cast<std::size_t>(a)]; }
  Eigen::MatrixXd N(const Eigen::VectorXd& a) const;
  Eigen::MatrixXd derivative(const Eigen::VectorXd& a, int i) const;  ///< ∂N/∂a_i
  Eigen::MatrixXd H(const Eigen::MatrixXd& Z) const;                  ///< tr(Z S_ab), Z symmetric

  // The same into memory that the caller keeps, for the inner loops of solvers. F, r x n, comes
  // from factor(a).
  void factor(const Eigen::Ref<const Eigen::VectorXd>& a, Eigen::MatrixXd& F) const;
  static void N(const Eigen::MatrixXd& F, Eigen::MatrixXd& out) {
    out.noalias() = F.transpose() * F;
  }
  void derivative(const Eigen::MatrixXd& F, int i, Eigen::MatrixXd& out) const;
  /// ∂N/∂a_0, ∂N/∂a_1, ... side by side, n x n p
  void derivatives(const Eigen::MatrixXd& F, Eigen::MatrixXd& out) const;
  void H(const Eigen::MatrixXd& Z, Eigen::MatrixXd& out) const;

  /// Scaled: limit 1.
  const std::vector<PeakConstraint>& peaks() const { return peaks_; }

  Eigen::VectorXd toScaled(const Eigen::VectorXd& amplitudes) const { return amplitudes / scale_; }
  Eigen::VectorXd toAmplitudes(const Eigen::VectorXd& a) const { return scale_ * a; }
  /// ½‖a‖² in the original units
  double toCost(double scaled_cost) const { return scale_ * scale_ * scaled_cost; }
  /// Y with Y Yᵀ the multiplier of the original constraint, of the positive part of Z. Where
  /// responses grow over decades the product would lose the digits that C has put in place.
  Eigen::MatrixXd toRoot(const Eigen::MatrixXd& Z) const;
  Eigen::MatrixXd fromRoot(const Eigen::MatrixXd& Y) const;  ///< Z again

 private:
  static std::size_t index(int a, int b) {
    const int i = std::max(a, b), j = std::min(a, b);
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(i + 1) / 2 +
           static_cast<std::size_t>(j);
  }

  int p_;
  double scale_;
  Eigen::MatrixXd C_, R_, S_00_;
  Eigen::MatrixXd factors_, offset_;  ///< [F_0' F_1' ...], r x n p; F_0, empty from rest
  std::vector<Eigen::MatrixXd> S_, S_offset_;
  std::vector<PeakConstraint> peaks_;
};

}  // namespace explore_opt
