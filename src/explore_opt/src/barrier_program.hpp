/// One relaxation of the paper's algorithm with a log-det barrier.
#pragma once

#include <Eigen/Cholesky>

#include "quadratic_program.hpp"
#include "smooth_program.hpp"

namespace explore_opt {

/// min ½‖a‖² - μ log det S(a),  S(a) = F_0 + Σ a_i F_i = lin(a; ã) - R: the constraint N(a) ⪰ R
/// with N replaced by its lower bound from M Mᵀ ⪰ M Lᵀ + L Mᵀ - L Lᵀ, L = M(ã); F_i = ∂N/∂a_i(ã),
/// F_0 = N(ã) - Σ ã_i F_i - R (= -N(ã) - R from rest). Cholesky decides the domain. At its
/// minimiser Z = μ S⁻¹ is dual feasible and the duality gap of ½‖a‖² is n μ.
class BarrierProgram : public SmoothProgram {
 public:
  BarrierProgram(const QuadraticProgram& program, const Eigen::VectorXd& candidate);
  void setWeight(double mu) { mu_ = mu; }

  int numVariables() const override { return static_cast<int>(F_.size()); }
  bool objective(const Eigen::VectorXd& a, double& f) override;
  bool gradient(const Eigen::VectorXd& a, Eigen::VectorXd& g) override;
  Positions hessianPositions() const override;
  bool hessian(const Eigen::VectorXd& a, double weight, const Eigen::VectorXd& multipliers,
               Eigen::VectorXd& values) override;

  Eigen::MatrixXd slack(const Eigen::VectorXd& a) const;        ///< S(a)
  Eigen::MatrixXd certificate(const Eigen::VectorXd& a) const;  ///< μ S(a)⁻¹
  /// ½‖a‖² minus the dual value of certificate(a): tr(Z S) + ½‖a - c‖², c_i = tr(Z F_i). Equals n μ
  /// at the minimiser.
  double gap(const Eigen::VectorXd& a) const;

 private:
  bool factorise(const Eigen::VectorXd& a);  ///< S(a) = L Lᵀ; false outside the cone
  void slack(const Eigen::VectorXd& a, Eigen::MatrixXd& out) const;

  double mu_ = 1.0;
  Eigen::MatrixXd F0_;
  std::vector<Eigen::MatrixXd> F_;
  // Kept from one evaluation to the next, so that none asks for memory.
  Eigen::MatrixXd S_, half_;
  Eigen::LLT<Eigen::MatrixXd> llt_;
  std::vector<Eigen::MatrixXd> whitened_;
};

}  // namespace explore_opt
