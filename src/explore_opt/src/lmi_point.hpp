/// One point of the path a linear matrix inequality's solver follows, and the steps from it.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "lmi_solver.hpp"

namespace explore_opt {

/// A block with its slopes side by side, so that each congruence is a product of large matrices.
struct StackedBlock {
  explicit StackedBlock(const LmiBlock& block);

  const LmiBlock& block;
  Eigen::MatrixXd stack;  ///< [A_1 A_2 ...], n x n count; empty where variables are entries of S

  /// Σ d_k A_k over its own variables
  void change(const Eigen::Ref<const Eigen::VectorXd>& d, Eigen::MatrixXd& out) const;
  /// Adds tr(A_k X), X symmetric.
  void addTraces(const Eigen::MatrixXd& X, Eigen::Ref<Eigen::VectorXd> sum) const;
};

/// A block seen in the coordinates where S and X are the same diagonal matrix (Nesterov and Todd):
/// Gᵀ S G = G⁻¹ X G⁻ᵀ = diag(λ). It keeps its memory from one iteration to the next.
class ScaledBlock {
 public:
  explicit ScaledBlock(const StackedBlock& source);

  /// False if S or X is not positive definite.
  bool moveTo(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::MatrixXd& X);
  /// Adds tr(A_k G Gᵀ A_l G Gᵀ), lower triangle.
  void addProducts(Eigen::Ref<Eigen::MatrixXd> sum);
  /// Gᵀ A_k G packed, a column each
  const Eigen::MatrixXd& columns();

  /// dS = Gᵀ (Σ d_k A_k) G, dX = the rest of what the last wish() wanted.
  void take(const Eigen::Ref<const Eigen::VectorXd>& dy);
  /// What dS + dX shall be for λ∘λ = `target`, less the products of the step before (`correct`);
  /// adds the right side's share of it.
  void wish(double target, bool correct, Eigen::Ref<Eigen::VectorXd> right);
  /// Adds tr(A_k G Gᵀ A(d) G Gᵀ).
  void addNormal(const Eigen::Ref<const Eigen::VectorXd>& d, Eigen::Ref<Eigen::VectorXd> sum);

  double longestInY(double fraction) { return longest(dS_, fraction); }  ///< at most 1
  double longestInX(double fraction) { return longest(dX_, fraction); }
  /// tr of (diag(λ) + t_y dS)(diag(λ) + t_x dX)
  double productAfter(double t_y, double t_x) const;
  const Eigen::MatrixXd& changeOfX();  ///< G dX Gᵀ

  const StackedBlock& source() const { return *source_; }
  double product() const { return lambda_.squaredNorm(); }  ///< tr(X S)
  Eigen::Index size() const { return lambda_.size(); }
  Eigen::Index packedSize() const { return packed_.size(); }
  int first() const { return source_->block.first; }
  int count() const { return source_->block.count; }

 private:
  bool entriesOnly() const { return source_->stack.size() == 0; }
  void change(const Eigen::Ref<const Eigen::VectorXd>& d, Eigen::MatrixXd& out);
  void addTraces(const Eigen::MatrixXd& R, Eigen::Ref<Eigen::VectorXd> sum);
  void fillColumns();
  void fillColumnsOfEntries();
  double longest(const Eigen::MatrixXd& d, double fraction);

  const StackedBlock* source_;
  Eigen::VectorXd lambda_, packed_;
  Eigen::MatrixXd G_, G_turned_, columns_, S_, dS_, dX_, wanted_, left_, right_;
  Eigen::MatrixXd half_, image_;  ///< several congruences at once
  Eigen::LLT<Eigen::MatrixXd> llt_S_, llt_X_;
};

/// All blocks at one point. Once built, it asks the heap for nothing while its blocks are no larger
/// than quad_support::kStackOrder.
class LmiPoint {
 public:
  LmiPoint(const LmiProgram& program, const std::vector<StackedBlock>& blocks);

  /// Gap and residual of a solution
  void measure(LmiSolution& solution);
  /// False if an S or X is not positive definite.
  bool moveTo(const LmiSolution& solution);

  double mu() const;  ///< Σ tr(X S) over the order of all blocks
  /// Newton's step in y towards λ∘λ = `target`, less the products of the step before (`correct`).
  const Eigen::VectorXd& step(double target, bool correct);
  double longestInY(double fraction);  ///< at most 1
  double longestInX(double fraction);
  double muAfter(double t_y, double t_x) const;  ///< after steps of these lengths
  const Eigen::MatrixXd& changeOfX(std::size_t j) { return blocks_[j].changeOfX(); }

 private:
  void normal(const Eigen::VectorXd& d, Eigen::VectorXd& sum);  ///< Σ_j tr(A_k G Gᵀ A(d) G Gᵀ)
  void solve();
  void applyInverse(Eigen::VectorXd& v) const;  ///< (RᵀR)⁻¹
  double refine();
  bool factoriseProducts();
  void factoriseRoot();

  const LmiProgram& program_;
  std::vector<ScaledBlock> blocks_;
  Eigen::Index order_ = 0;
  Eigen::MatrixXd M_, root_, R_;  ///< R upper triangle, RᵀR the normal equations' matrix
  Eigen::LLT<Eigen::MatrixXd> llt_;
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
  Eigen::VectorXd right_, dy_, rest_, next_, left_;
  std::vector<Eigen::MatrixXd> slack_;  ///< S_j
  bool from_root_ = false;
};

}  // namespace explore_opt
