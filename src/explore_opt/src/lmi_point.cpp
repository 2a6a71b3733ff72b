#include "lmi_point.hpp"

#include <algorithm>
#include <cmath>

#include "constants.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSolved = 1e-13;  // residual of the normal equations, of their right side
constexpr int kRefinements = 4;

}  // namespace

LmiPoint::LmiPoint(const LmiProgram& program, const std::vector<StackedBlock>& blocks)
    : program_(program), blocks_(blocks.begin(), blocks.end()) {
  const Index m = program.reward.size();
  Index rows = 0;
  for (const ScaledBlock& b : blocks_) {
    order_ += b.size();
    rows += b.packedSize();
    slack_.emplace_back(b.size(), b.size());
  }
  M_.resize(m, m);
  R_.resize(m, m);
  root_.resize(rows, m);
  llt_ = Eigen::LLT<MatrixXd>(m);
  qr_ = Eigen::HouseholderQR<MatrixXd>(rows, m);
  for (VectorXd* v : {&right_, &dy_, &rest_, &next_, &left_}) v->setZero(m);
}

void LmiPoint::measure(LmiSolution& solution) {
  rest_ = program_.reward;
  solution.gap = 0.0;
  for (std::size_t j = 0; j < blocks_.size(); ++j) {
    const StackedBlock& source = blocks_[j].source();
    const MatrixXd& X = solution.multipliers[j];
    source.change(solution.y.segment(source.block.first, source.block.count), slack_[j]);
    slack_[j] += source.block.constant;
    solution.gap += X.cwiseProduct(slack_[j]).sum();
    source.addTraces(X, rest_.segment(source.block.first, source.block.count));
  }
  solution.residual = rest_.cwiseAbs().maxCoeff();
}

bool LmiPoint::moveTo(const LmiSolution& solution) {
  for (std::size_t j = 0; j < blocks_.size(); ++j) {
    ScaledBlock& b = blocks_[j];
    if (!b.moveTo(solution.y.segment(b.first(), b.count()), solution.multipliers[j])) return false;
  }
  from_root_ = false;
  if (!factoriseProducts()) factoriseRoot();
  return true;
}

/// M_kl = Σ_j tr(A_k W A_l W), W = G Gᵀ, by Cholesky.
bool LmiPoint::factoriseProducts() {
  M_.setZero();
  for (ScaledBlock& b : blocks_)
    b.addProducts(M_.block(b.first(), b.first(), b.count(), b.count()));
  llt_.compute(M_);
  if (llt_.info() != Eigen::Success) return false;
  R_ = llt_.matrixU();
  return R_.allFinite();
}

/// The triangle of a QR of the root: near the end the products are too ill-conditioned.
void LmiPoint::factoriseRoot() {
  root_.setZero();
  Index next = 0;
  for (ScaledBlock& b : blocks_) {
    root_.block(next, b.first(), b.packedSize(), b.count()) = b.columns();
    next += b.packedSize();
  }
  qr_.compute(root_);
  R_ = qr_.matrixQR().topRows(root_.cols()).triangularView<Eigen::Upper>();
  from_root_ = true;
}

void LmiPoint::normal(const VectorXd& d, VectorXd& sum) {
  sum.setZero();
  for (ScaledBlock& b : blocks_)
    b.addNormal(d.segment(b.first(), b.count()), sum.segment(b.first(), b.count()));
}

void LmiPoint::applyInverse(VectorXd& v) const {
  R_.triangularView<Eigen::Upper>().transpose().solveInPlace(v);
  R_.triangularView<Eigen::Upper>().solveInPlace(v);
}

/// dy with (RᵀR) δ = right - M dy, M applied block by block: what forming M has rounded is mended.
/// @returns the largest residual
double LmiPoint::refine() {
  dy_ = right_;
  applyInverse(dy_);
  normal(dy_, rest_);
  rest_ = right_ - rest_;
  double residual = rest_.cwiseAbs().maxCoeff();
  const double enough = kSolved * right_.cwiseAbs().maxCoeff();
  for (int i = 0; i < kRefinements && residual > enough; ++i) {
    next_ = rest_;
    applyInverse(next_);
    next_ += dy_;
    normal(next_, left_);
    left_ = right_ - left_;
    const double now = left_.cwiseAbs().maxCoeff();
    if (!(now < residual)) break;
    const bool slow = now > 0.5 * residual;
    dy_.swap(next_);
    rest_.swap(left_);
    residual = now;
    if (slow) break;
  }
  return residual;
}

void LmiPoint::solve() {
  const double residual = refine();
  if (from_root_ || residual <= 1e3 * kSolved * right_.cwiseAbs().maxCoeff()) return;
  factoriseRoot();
  refine();
}

const VectorXd& LmiPoint::step(double target, bool correct) {
  right_ = program_.reward;
  for (ScaledBlock& b : blocks_) b.wish(target, correct, right_.segment(b.first(), b.count()));
  solve();
  for (ScaledBlock& b : blocks_) b.take(dy_.segment(b.first(), b.count()));
  return dy_;
}

double LmiPoint::longestInY(double fraction) {
  double t = 1.0;
  for (ScaledBlock& b : blocks_) t = std::min(t, b.longestInY(fraction));
  return t;
}

double LmiPoint::longestInX(double fraction) {
  double t = 1.0;
  for (ScaledBlock& b : blocks_) t = std::min(t, b.longestInX(fraction));
  return t;
}

double LmiPoint::mu() const {
  double sum = 0.0;
  for (const ScaledBlock& b : blocks_) sum += b.product();
  return sum / static_cast<double>(order_);
}

double LmiPoint::muAfter(double t_y, double t_x) const {
  double sum = 0.0;
  for (const ScaledBlock& b : blocks_) sum += b.productAfter(t_y, t_x);
  return sum / static_cast<double>(order_);
}

}  // namespace explore_opt
