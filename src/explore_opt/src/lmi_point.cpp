#include "lmi_point.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSolved = 1e-13;  // residual of the normal equations, of their right side
constexpr int kRefinements = 4;
constexpr Index kFastEntries = 4096;  // of a matrix that stays in the first-level cache: 32 KB
constexpr double kRootTwo = 1.4142135623730950488;

/// Entry (i, j) of the lower triangle, row by row, for each of `count` variables.
template <typename Visit>
void forEntries(Index count, const Visit& visit) {
  Index i = 0, j = 0;
  for (Index k = 0; k < count; ++k) {
    visit(k, i, j);
    if (j == i) {
      ++i;
      j = 0;
    } else {
      ++j;
    }
  }
}

/// The lower triangle column by column, off-diagonal entries times √2: products of two such vectors
/// are traces of products.
void pack(const Eigen::Ref<const MatrixXd>& m, Eigen::Ref<VectorXd> out) {
  Index next = 0;
  for (Index j = 0; j < m.cols(); ++j) {
    const Index below = m.rows() - j - 1;
    out(next) = m(j, j);
    out.segment(next + 1, below) = kRootTwo * m.col(j).tail(below);
    next += below + 1;
  }
}

VectorXd packed(const MatrixXd& m) {
  VectorXd out(m.rows() * (m.rows() + 1) / 2);
  pack(m, out);
  return out;
}

MatrixXd unpacked(const VectorXd& packed, Index n) {
  MatrixXd m(n, n);
  Index next = 0;
  for (Index j = 0; j < n; ++j) {
    m(j, j) = packed(next++);
    for (Index i = j + 1; i < n; ++i) m(i, j) = m(j, i) = packed(next++) / kRootTwo;
  }
  return m;
}

/// Largest t <= 1 with diag(λ) + t d ⪰ 0, less a little.
double stepTo(const VectorXd& lambda, const MatrixXd& d, double fraction) {
  const VectorXd root = lambda.cwiseSqrt().cwiseInverse();
  const double least =
      quad_support::symmetricEigenvalues(root.asDiagonal() * d * root.asDiagonal())(0);
  return least < -fraction ? fraction / -least : 1.0;
}

/// U and λ of P = U diag(λ) Vᵀ. Near the path P is almost a multiple of a rotation, so P Pᵀ has
/// lost nothing; elsewhere the slower way.
bool leftFactors(const MatrixXd& P, MatrixXd& U, VectorXd& lambda) {
  const quad_support::SymmetricEigen eigen(P * P.transpose());
  if (eigen.values(0) > 1e-5 * eigen.values(eigen.values.size() - 1)) {
    lambda = eigen.values.cwiseSqrt();
    U = eigen.vectors;
    return lambda.allFinite();
  }
  const Eigen::JacobiSVD<MatrixXd> svd(P, Eigen::ComputeFullU);
  lambda = svd.singularValues();
  U = svd.matrixU();
  return lambda.minCoeff() > 0.0 && lambda.allFinite();
}

bool scale(ScaledBlock& block, const MatrixXd& S, const MatrixXd& X) {
  const Eigen::LLT<MatrixXd> llt_S(S), llt_X(X);
  if (llt_S.info() != Eigen::Success || llt_X.info() != Eigen::Success) return false;
  const MatrixXd L_X = llt_X.matrixL(), L_S = llt_S.matrixL();
  MatrixXd U;
  if (!leftFactors(L_X.transpose() * L_S, U, block.lambda)) return false;
  block.G = L_X * U * block.lambda.cwiseSqrt().cwiseInverse().asDiagonal();
  if (block.source->stack.size() > 0) block.source->columns(block.G, block.columns);
  return true;
}

}  // namespace

StackedBlock::StackedBlock(const LmiBlock& b) : block(b) {
  if (b.slopes.empty()) return;
  stack.resize(b.size(), Index{b.size()} * b.count);
  for (int k = 0; k < b.count; ++k)
    stack.middleCols(Index{k} * b.size(), b.size()) = b.slopes[static_cast<std::size_t>(k)];
}

MatrixXd StackedBlock::change(const VectorXd& d) const {
  const Index n = block.size();
  if (stack.size() > 0) {
    const VectorXd sum = Map<const MatrixXd>(stack.data(), n * n, block.count) * d;
    return Map<const MatrixXd>(sum.data(), n, n);
  }
  MatrixXd m = MatrixXd::Zero(n, n);
  forEntries(block.count, [&](Index k, Index i, Index j) { m(i, j) = m(j, i) = d(k); });
  return m;
}

VectorXd StackedBlock::traces(const MatrixXd& X) const {
  if (stack.size() > 0)
    return Map<const MatrixXd>(stack.data(), X.size(), block.count).transpose() * X.reshaped();
  VectorXd t(block.count);
  forEntries(block.count,
             [&](Index k, Index i, Index j) { t(k) = i == j ? X(i, i) : X(i, j) + X(j, i); });
  return t;
}

void StackedBlock::columns(const MatrixXd& G, MatrixXd& out) const {
  const Index n = block.size(), count = block.count;
  out.resize(n * (n + 1) / 2, count);
  if (stack.size() == 0) {
    forEntries(count, [&](Index k, Index i, Index j) {
      MatrixXd image = G.row(i).transpose() * G.row(j);
      if (i != j) image += image.transpose().eval();
      pack(image, out.col(k));
    });
    return;
  }
  // Gᵀ A_k, turned, and Gᵀ again: as many at a time as the fast memory holds.
  const MatrixXd turn = G.transpose();
  const Index most = std::clamp<Index>(kFastEntries / (n * n), 1, count);
  MatrixXd half(n, n * most), image(n, n * most);
  for (Index first = 0; first < count; first += most) {
    const Index some = std::min(most, count - first);
    half.leftCols(n * some).noalias() = turn * stack.middleCols(n * first, n * some);
    for (Index k = 0; k < some; ++k) half.middleCols(n * k, n).transposeInPlace();
    image.leftCols(n * some).noalias() = turn * half.leftCols(n * some);
    for (Index k = 0; k < some; ++k) pack(image.middleCols(n * k, n), out.col(first + k));
  }
}

MatrixXd ScaledBlock::change(const VectorXd& d) const {
  if (columns.size() == 0) return G.transpose() * source->change(d) * G;
  return unpacked(columns * d, G.rows());
}

VectorXd ScaledBlock::traces(const MatrixXd& R) const {
  if (columns.size() == 0) return source->traces(G * R * G.transpose());
  return columns.transpose() * packed(R);
}

LmiPoint::LmiPoint(const LmiProgram& program, const std::vector<StackedBlock>& blocks)
    : program_(program), blocks_(blocks.size()) {
  for (std::size_t j = 0; j < blocks.size(); ++j) {
    blocks_[j].source = &blocks[j];
    order_ += blocks[j].block.size();
  }
}

bool LmiPoint::moveTo(const LmiSolution& solution) {
  for (std::size_t j = 0; j < blocks_.size(); ++j) {
    const StackedBlock& source = *blocks_[j].source;
    const VectorXd y = solution.y.segment(source.block.first, source.block.count);
    if (!scale(blocks_[j], source.block.constant + source.change(y), solution.multipliers[j]))
      return false;
  }
  from_root_ = false;
  if (!factoriseProducts()) factoriseRoot();
  return true;
}

/// M_kl = Σ_j tr(A_k W A_l W), W = G Gᵀ, by Cholesky.
bool LmiPoint::factoriseProducts() {
  const Index m = program_.reward.size();
  MatrixXd M = MatrixXd::Zero(m, m);
  for (const ScaledBlock& b : blocks_) {
    const LmiBlock& block = b.source->block;
    auto part = M.block(block.first, block.first, block.count, block.count);
    if (b.columns.size() > 0) {
      part.selfadjointView<Eigen::Lower>().rankUpdate(b.columns.transpose());
      continue;
    }
    // (e_i e_jᵀ + e_j e_iᵀ) and (e_k e_lᵀ + e_l e_kᵀ), halved on the diagonal: 2(W_ik W_jl + W_il
    // W_jk)
    const MatrixXd W = b.G * b.G.transpose();
    forEntries(block.count, [&](Index l, Index p, Index q) {
      const double half = p == q ? 1.0 : 2.0;
      forEntries(block.count, [&](Index k, Index i, Index j) {
        if (k >= l)
          part(k, l) += (i == j ? 0.5 : 1.0) * half * (W(i, p) * W(j, q) + W(i, q) * W(j, p));
      });
    });
  }
  const Eigen::LLT<MatrixXd> llt(M);
  if (llt.info() != Eigen::Success) return false;
  R_ = llt.matrixU();
  return R_.allFinite();
}

/// The triangle of a QR of the root: near the end the products are too ill-conditioned.
void LmiPoint::factoriseRoot() {
  Index rows = 0;
  for (const ScaledBlock& b : blocks_) rows += b.G.rows() * (b.G.rows() + 1) / 2;
  MatrixXd root = MatrixXd::Zero(rows, program_.reward.size());
  Index next = 0;
  for (const ScaledBlock& b : blocks_) {
    const LmiBlock& block = b.source->block;
    MatrixXd columns = b.columns;
    if (columns.size() == 0) b.source->columns(b.G, columns);
    root.block(next, block.first, columns.rows(), block.count) = columns;
    next += columns.rows();
  }
  R_ = Eigen::HouseholderQR<Eigen::Ref<MatrixXd>>(root)
           .matrixQR()
           .topRows(root.cols())
           .triangularView<Eigen::Upper>();
  from_root_ = true;
}

VectorXd LmiPoint::normal(const VectorXd& d) const {
  VectorXd sum = VectorXd::Zero(d.size());
  for (const ScaledBlock& b : blocks_) {
    const LmiBlock& block = b.source->block;
    sum.segment(block.first, block.count) +=
        b.traces(b.change(d.segment(block.first, block.count)));
  }
  return sum;
}

/// Steps (RᵀR) δ = right - M d with M applied block by block: what forming M has rounded is mended.
VectorXd LmiPoint::refined(const VectorXd& right, double& residual) const {
  const auto upper = R_.triangularView<Eigen::Upper>();
  VectorXd best = upper.solve(upper.transpose().solve(right).eval());
  VectorXd rest = right - normal(best);
  residual = rest.cwiseAbs().maxCoeff();
  const double enough = kSolved * right.cwiseAbs().maxCoeff();
  for (int i = 0; i < kRefinements && residual > enough; ++i) {
    const VectorXd next = best + upper.solve(upper.transpose().solve(rest).eval());
    const VectorXd left = right - normal(next);
    const double now = left.cwiseAbs().maxCoeff();
    if (!(now < residual)) break;
    const bool slow = now > 0.5 * residual;
    best = next;
    rest = left;
    residual = now;
    if (slow) break;
  }
  return best;
}

VectorXd LmiPoint::solve(const VectorXd& right) {
  double residual = 0.0;
  const VectorXd d = refined(right, residual);
  if (from_root_ || residual <= 1e3 * kSolved * right.cwiseAbs().maxCoeff()) return d;
  factoriseRoot();
  return refined(right, residual);
}

double LmiPoint::mu() const {
  double sum = 0.0;
  for (const ScaledBlock& b : blocks_) sum += b.lambda.squaredNorm();
  return sum / static_cast<double>(order_);
}

VectorXd LmiPoint::step(double target, bool correct) {
  std::vector<MatrixXd> wanted;  // dS + dX, scaled
  VectorXd right = program_.reward;
  for (ScaledBlock& b : blocks_) {
    const Index n = b.lambda.size();
    MatrixXd r = MatrixXd::Zero(n, n);
    if (correct) {
      const MatrixXd product = b.dS * b.dX;
      r = -0.5 * (product + product.transpose());
    }
    r.diagonal().array() += target;
    for (Index k = 0; k < n; ++k) {
      for (Index i = 0; i < n; ++i) r(i, k) *= 2.0 / (b.lambda(i) + b.lambda(k));
    }
    // without -λ, whose product with the columns is part of the residual
    const LmiBlock& block = b.source->block;
    right.segment(block.first, block.count) += b.traces(r);
    r.diagonal() -= b.lambda;
    wanted.push_back(std::move(r));
  }
  const VectorXd dy = solve(right);
  for (std::size_t j = 0; j < blocks_.size(); ++j) {
    ScaledBlock& b = blocks_[j];
    b.dS = b.change(dy.segment(b.source->block.first, b.source->block.count));
    b.dX = wanted[j] - b.dS;
  }
  return dy;
}

double LmiPoint::longestInY(double fraction) const {
  double t = 1.0;
  for (const ScaledBlock& b : blocks_) t = std::min(t, stepTo(b.lambda, b.dS, fraction));
  return t;
}

double LmiPoint::longestInX(double fraction) const {
  double t = 1.0;
  for (const ScaledBlock& b : blocks_) t = std::min(t, stepTo(b.lambda, b.dX, fraction));
  return t;
}

double LmiPoint::muAfter(double t_y, double t_x) const {
  double sum = 0.0;
  for (const ScaledBlock& b : blocks_) {
    const MatrixXd diagonal = b.lambda.asDiagonal();
    sum += (diagonal + t_y * b.dS).cwiseProduct(diagonal + t_x * b.dX).sum();
  }
  return sum / static_cast<double>(order_);
}

MatrixXd LmiPoint::changeOfX(std::size_t j) const {
  const MatrixXd d = blocks_[j].G * blocks_[j].dX * blocks_[j].G.transpose();
  return 0.5 * (d + d.transpose());
}

}  // namespace explore_opt
