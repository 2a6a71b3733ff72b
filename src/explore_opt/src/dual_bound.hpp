/// The convex dual of the design problem: a certified lower bound, and where to look for the
/// amplitudes.
#pragma once

#include <Eigen/Core>

#include "quadratic_program.hpp"

namespace explore_opt {

/// Solution of   max tr(R Z)   s.t.   Z ⪰ 0,   2 H(Z) ⪯ I.
struct DualSolution {
  Eigen::MatrixXd Z;       ///< n x n, strictly feasible
  Eigen::MatrixXd lifted;  ///< 𝒜 ⪰ 0, p x p: amplitudes a aᵀ with the rank constraint dropped
  double gap = 0.0;        ///< bound on the distance of tr(R Z) to the maximum
  int newton_steps = 0;
};

/// Path following on  -tr(R Z)/μ - log det Z - log det(I - 2 H(Z))  by damped Newton steps, which
/// are certain to converge because this barrier is self-concordant. Ends with gap (n + p) μ <=
/// `gap`.
DualSolution solveDual(const QuadraticProgram& program, double gap);

/// Value and derivatives of that barrier in the entries of the lower triangle of Z.
class DualBarrier {
 public:
  explicit DualBarrier(const QuadraticProgram& program);
  int numVariables() const { return static_cast<int>(basis_.size()); }
  Eigen::MatrixXd matrix(const Eigen::VectorXd& z) const;
  bool value(const Eigen::MatrixXd& Z, double mu, double& f) const;  ///< false outside the domain
  /// The Hessian is rootᵀ root.
  void gradientAndRoot(const Eigen::MatrixXd& Z, double mu, Eigen::VectorXd& gradient,
                       Eigen::MatrixXd& root) const;
  Eigen::MatrixXd slack(const Eigen::MatrixXd& Z) const;  ///< I - 2 H(Z)

 private:
  const QuadraticProgram& program_;
  std::vector<Eigen::MatrixXd> basis_;   ///< E_k: Z = Σ z_k E_k
  std::vector<Eigen::MatrixXd> images_;  ///< 2 H(E_k)
  Eigen::VectorXd reward_;               ///< tr(R E_k)
};

}  // namespace explore_opt
