#include <algorithm>
#include <cmath>

#include "constants.hpp"
#include "lmi_point.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

void unpack(const VectorXd& packed, MatrixXd& out) {
  Index next = 0;
  for (Index j = 0; j < out.cols(); ++j) {
    out(j, j) = packed(next++);
    for (Index i = j + 1; i < out.rows(); ++i) out(i, j) = out(j, i) = packed(next++) / kRootTwo;
  }
}

/// U and λ of P = U diag(λ) Vᵀ. Near the path P is almost a multiple of a rotation, so P Pᵀ has
/// lost nothing; elsewhere the slower way.
bool leftFactors(const MatrixXd& P, MatrixXd& square, MatrixXd& U, VectorXd& lambda) {
  square.noalias() = P * P.transpose();
  quad_support::symmetricEigen(square, lambda, U);
  if (lambda(0) > 1e-5 * lambda(lambda.size() - 1)) {
    lambda = lambda.cwiseSqrt();
    return lambda.allFinite();
  }
  quad_support::leftSingular(P, lambda, U);
  return lambda.minCoeff() > 0.0 && lambda.allFinite();
}

}  // namespace

StackedBlock::StackedBlock(const LmiBlock& b) : block(b) {
  if (b.slopes.empty()) return;
  stack.resize(b.size(), Index{b.size()} * b.count);
  for (int k = 0; k < b.count; ++k)
    stack.middleCols(Index{k} * b.size(), b.size()) = b.slopes[static_cast<std::size_t>(k)];
}

void StackedBlock::change(const Eigen::Ref<const VectorXd>& d, MatrixXd& out) const {
  const Index n = block.size();
  out.resize(n, n);
  if (stack.size() > 0) {
    Map<VectorXd>(out.data(), n * n).noalias() =
        Map<const MatrixXd>(stack.data(), n * n, block.count) * d;
    return;
  }
  out.setZero();
  forEntries(block.count, [&](Index k, Index i, Index j) { out(i, j) = out(j, i) = d(k); });
}

void StackedBlock::addTraces(const MatrixXd& X, Eigen::Ref<VectorXd> sum) const {
  if (stack.size() > 0) {
    sum.noalias() += Map<const MatrixXd>(stack.data(), X.size(), block.count).transpose() *
                     Map<const VectorXd>(X.data(), X.size());
    return;
  }
  forEntries(block.count,
             [&](Index k, Index i, Index j) { sum(k) += i == j ? X(i, i) : X(i, j) + X(j, i); });
}

ScaledBlock::ScaledBlock(const StackedBlock& source) : source_(&source) {
  const Index n = source.block.size(), count = source.block.count;
  for (MatrixXd* m : {&G_, &G_turned_, &S_, &dS_, &dX_, &wanted_, &left_, &right_})
    m->setZero(n, n);
  lambda_.setZero(n);
  packed_.setZero(n * (n + 1) / 2);
  columns_.resize(packed_.size(), count);
  llt_S_ = Eigen::LLT<MatrixXd>(n);
  llt_X_ = Eigen::LLT<MatrixXd>(n);
  if (entriesOnly()) return;
  const Index most = std::clamp<Index>(kFastEntries / (n * n), 1, count);
  half_.resize(n, n * most);
  image_.resize(n, n * most);
}

bool ScaledBlock::moveTo(const Eigen::Ref<const VectorXd>& y, const MatrixXd& X) {
  source_->change(y, S_);
  S_ += source_->block.constant;
  llt_S_.compute(S_);
  llt_X_.compute(X);
  if (llt_S_.info() != Eigen::Success || llt_X_.info() != Eigen::Success) return false;
  left_ = llt_X_.matrixL();
  right_ = llt_S_.matrixL();
  dX_.noalias() = left_.transpose() * right_;  // the step of the point before is not needed here
  if (!leftFactors(dX_, dS_, right_, lambda_)) return false;
  G_.noalias() = left_ * right_;
  for (Index k = 0; k < lambda_.size(); ++k) G_.col(k) /= std::sqrt(lambda_(k));
  if (!entriesOnly()) fillColumns();
  return true;
}

const MatrixXd& ScaledBlock::columns() {
  if (entriesOnly()) fillColumnsOfEntries();
  return columns_;
}

void ScaledBlock::fillColumnsOfEntries() {
  const Index n = size();
  forEntries(count(), [&](Index k, Index i, Index j) {
    Index next = 0;
    for (Index b = 0; b < n; ++b) {
      for (Index a = b; a < n; ++a) {
        double entry = G_(i, a) * G_(j, b);
        if (i != j) entry += G_(j, a) * G_(i, b);
        columns_(next++, k) = (a == b ? 1.0 : kRootTwo) * entry;
      }
    }
  });
}

/// Gᵀ A_k, turned, and Gᵀ again: as many at a time as the fast memory holds.
void ScaledBlock::fillColumns() {
  const Index n = size(), most = half_.cols() / n;
  G_turned_ = G_.transpose();
  for (Index first = 0; first < count(); first += most) {
    const Index some = std::min(most, count() - first);
    half_.leftCols(n * some).noalias() = G_turned_ * source_->stack.middleCols(n * first, n * some);
    for (Index k = 0; k < some; ++k) half_.middleCols(n * k, n).transposeInPlace();
    image_.leftCols(n * some).noalias() = G_turned_ * half_.leftCols(n * some);
    for (Index k = 0; k < some; ++k) pack(image_.middleCols(n * k, n), columns_.col(first + k));
  }
}

void ScaledBlock::addProducts(Eigen::Ref<MatrixXd> sum) {
  if (!entriesOnly()) {
    sum.selfadjointView<Eigen::Lower>().rankUpdate(columns_.transpose());
    return;
  }
  // (e_i e_jᵀ + e_j e_iᵀ) and (e_k e_lᵀ + e_l e_kᵀ), halved on the diagonal: 2(W_ik W_jl + W_il
  // W_jk)
  MatrixXd& W = left_;
  W.noalias() = G_ * G_.transpose();
  forEntries(count(), [&](Index l, Index p, Index q) {
    const double half = p == q ? 1.0 : 2.0;
    forEntries(count(), [&](Index k, Index i, Index j) {
      if (k >= l)
        sum(k, l) += (i == j ? 0.5 : 1.0) * half * (W(i, p) * W(j, q) + W(i, q) * W(j, p));
    });
  });
}

void ScaledBlock::change(const Eigen::Ref<const VectorXd>& d, MatrixXd& out) {
  if (entriesOnly()) {
    source_->change(d, left_);
    right_.noalias() = left_ * G_;
    out.noalias() = G_.transpose() * right_;
    return;
  }
  packed_.noalias() = columns_ * d;
  unpack(packed_, out);
}

void ScaledBlock::addTraces(const MatrixXd& R, Eigen::Ref<VectorXd> sum) {
  if (entriesOnly()) {
    left_.noalias() = G_ * R;
    right_.noalias() = left_ * G_.transpose();
    source_->addTraces(right_, sum);
    return;
  }
  pack(R, packed_);
  sum.noalias() += columns_.transpose() * packed_;
}

void ScaledBlock::addNormal(const Eigen::Ref<const VectorXd>& d, Eigen::Ref<VectorXd> sum) {
  if (entriesOnly()) {
    change(d, S_);  // S itself is not needed any more at this point
    addTraces(S_, sum);
    return;
  }
  packed_.noalias() = columns_ * d;
  sum.noalias() += columns_.transpose() * packed_;
}

void ScaledBlock::wish(double target, bool correct, Eigen::Ref<VectorXd> right) {
  const Index n = size();
  wanted_.setZero();
  if (correct) {
    left_.noalias() = dS_ * dX_;
    for (Index k = 0; k < n; ++k) {
      for (Index i = 0; i < n; ++i) wanted_(i, k) = -0.5 * (left_(i, k) + left_(k, i));
    }
  }
  wanted_.diagonal().array() += target;
  for (Index k = 0; k < n; ++k) {
    for (Index i = 0; i < n; ++i) wanted_(i, k) *= 2.0 / (lambda_(i) + lambda_(k));
  }
  // without -λ, whose product with the columns is part of the residual
  addTraces(wanted_, right);
  wanted_.diagonal() -= lambda_;
}

void ScaledBlock::take(const Eigen::Ref<const VectorXd>& dy) {
  change(dy, dS_);
  dX_ = wanted_ - dS_;
}

/// Largest t <= 1 with diag(λ) + t d ⪰ 0, less a little.
double ScaledBlock::longest(const MatrixXd& d, double fraction) {
  for (Index k = 0; k < size(); ++k) {
    for (Index i = 0; i < size(); ++i) left_(i, k) = d(i, k) / std::sqrt(lambda_(i) * lambda_(k));
  }
  const double least = quad_support::smallestEigenvalue(left_);
  return least < -fraction ? fraction / -least : 1.0;
}

double ScaledBlock::productAfter(double t_y, double t_x) const {
  return lambda_.squaredNorm() +
         (t_y * dS_.diagonal() + t_x * dX_.diagonal()).cwiseProduct(lambda_).sum() +
         t_y * t_x * dS_.cwiseProduct(dX_).sum();
}

const MatrixXd& ScaledBlock::changeOfX() {
  left_.noalias() = G_ * dX_;
  right_.noalias() = left_ * G_.transpose();
  for (Index k = 0; k < size(); ++k) {
    for (Index i = 0; i < k; ++i) right_(i, k) = right_(k, i) = 0.5 * (right_(i, k) + right_(k, i));
  }
  return right_;
}

}  // namespace explore_opt
