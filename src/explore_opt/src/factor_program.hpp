/// The design problem with the matrix inequality written as N(a) - R = L Lᵀ, for a solver of smooth
/// programs.
#pragma once

#include "quadratic_program.hpp"
#include "smooth_program.hpp"

namespace explore_opt {

/// min ½‖a‖² s.t. the lower triangle of N(a) - R - L Lᵀ is zero, L lower triangular with a diagonal
/// of any sign, and room_k(a) >= 0 for each peak limit. (Written as room_k(a) = s_k² a limit would
/// have no slope in s_k where it is violated and s_k is zero.)
/// Variables: a, then L row by row. Constraints: the lower triangle row by row, then peaks.
/// ∂c/∂a_i = ∂N/∂a_i; the Hessian of λᵀc is 2 H(Λ) in a and -2 Λ_ik δ_jl in (L_ij, L_kl), Λ = (λ +
/// λᵀ)/2; a peak adds -2 λ_k Q_kᵀQ_k in a.
class FactorProgram : public SmoothProgram {
 public:
  explicit FactorProgram(const QuadraticProgram& program);

  int numVariables() const override { return p_ + triangle_; }
  int numConstraints() const override { return triangle_ + peaks_; }
  int numInequalities() const override { return peaks_; }
  bool objective(const Eigen::VectorXd& x, double& f) override;
  bool gradient(const Eigen::VectorXd& x, Eigen::VectorXd& g) override;
  void constraints(const Eigen::VectorXd& x, Eigen::VectorXd& c) override;
  Positions jacobianPositions() const override;
  void jacobian(const Eigen::VectorXd& x, Eigen::VectorXd& values) override;
  Positions hessianPositions() const override;
  bool hessian(const Eigen::VectorXd& x, double weight, const Eigen::VectorXd& multipliers,
               Eigen::VectorXd& values) override;

  /// a with the factor of N(a) - R (its positive part, where a is not feasible).
  Eigen::VectorXd startAt(const Eigen::VectorXd& a) const;
  Eigen::VectorXd amplitudesOf(const Eigen::VectorXd& x) const { return x.head(p_); }
  /// Z = -Λ of the solver's multipliers, and back.
  Eigen::MatrixXd certificateOf(const Eigen::VectorXd& multipliers) const;
  Eigen::VectorXd multipliersOf(const Eigen::MatrixXd& Z, const Eigen::VectorXd& nu) const;
  /// ν = -2 λ of the peak limits.
  Eigen::VectorXd peakMultipliersOf(const Eigen::VectorXd& multipliers) const;

 private:
  void readLower(const Eigen::VectorXd& x);  ///< L_
  int at(int i, int j) const { return i * (i + 1) / 2 + j; }

  const QuadraticProgram& program_;
  int p_, n_, triangle_, peaks_;
  // Kept from one evaluation to the next, so that none asks for memory.
  Eigen::MatrixXd F_, L_, difference_, Lambda_, H_;
  std::vector<Eigen::MatrixXd> slopes_;
};

}  // namespace explore_opt
