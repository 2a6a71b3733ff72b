/// One point of the path a linear matrix inequality's solver follows, and the steps from it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lmi_solver.hpp"

namespace explore_opt {

/// A block with its slopes side by side, so that each congruence is a product of large matrices.
struct StackedBlock {
  explicit StackedBlock(const LmiBlock& block);

  const LmiBlock& block;
  Eigen::MatrixXd stack;  ///< [A_1 A_2 ...], n x n count; empty where variables are entries of S

  Eigen::MatrixXd change(const Eigen::VectorXd& d) const;  ///< Σ d_k A_k over its own variables
  Eigen::VectorXd traces(const Eigen::MatrixXd& X) const;  ///< tr(A_k X), X symmetric
  /// Gᵀ A_k G packed, a column each. `out` keeps its memory from one iteration to the next.
  void columns(const Eigen::MatrixXd& G, Eigen::MatrixXd& out) const;
};

/// A block seen in the coordinates where S and X are the same diagonal matrix (Nesterov and Todd):
/// Gᵀ S G = G⁻¹ X G⁻ᵀ = diag(λ).
struct ScaledBlock {
  const StackedBlock* source = nullptr;
  Eigen::MatrixXd G;
  Eigen::VectorXd lambda;
  Eigen::MatrixXd columns;  ///< of source; empty where variables are entries of S
  Eigen::MatrixXd dS, dX;   ///< the step, scaled

  Eigen::MatrixXd change(const Eigen::VectorXd& d) const;  ///< Gᵀ (Σ d_k A_k) G
  Eigen::VectorXd traces(const Eigen::MatrixXd& R) const;  ///< tr(Gᵀ A_k G R), R symmetric
};

/// All blocks at one point.
class LmiPoint {
 public:
  LmiPoint(const LmiProgram& program, const std::vector<StackedBlock>& blocks);

  /// False if an S or X is not positive definite.
  bool moveTo(const LmiSolution& solution);

  double mu() const;  ///< Σ tr(X S) over the order of all blocks
  /// Newton's step in y towards λ∘λ = `target`, less the products of the step before (`correct`).
  Eigen::VectorXd step(double target, bool correct);
  double longestInY(double fraction) const;  ///< at most 1
  double longestInX(double fraction) const;
  double muAfter(double t_y, double t_x) const;  ///< after steps of these lengths
  Eigen::MatrixXd changeOfX(std::size_t j) const;

 private:
  Eigen::VectorXd normal(const Eigen::VectorXd& d) const;  ///< Σ_j tr(A_k G Gᵀ A(d) G Gᵀ)
  Eigen::VectorXd solve(const Eigen::VectorXd& right);
  Eigen::VectorXd refined(const Eigen::VectorXd& right, double& residual) const;
  bool factoriseProducts();
  void factoriseRoot();

  const LmiProgram& program_;
  std::vector<ScaledBlock> blocks_;
  Eigen::Index order_ = 0;
  Eigen::MatrixXd R_;  ///< upper triangle, RᵀR the normal equations' matrix up to rounding
  bool from_root_ = false;
};

}  // namespace explore_opt
