#include "quadratic_program.hpp"

#include <Eigen/LU>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd symmetric(const MatrixXd& m) { return 0.5 * (m + m.transpose()); }

void addTranspose(Eigen::Ref<MatrixXd> m) {
  for (Eigen::Index k = 0; k < m.cols(); ++k) {
    for (Eigen::Index i = 0; i <= k; ++i) m(i, k) = m(k, i) = m(i, k) + m(k, i);
  }
}

/// C with (F C)ᵀ F C = I and CᵀC diagonal, ascending. Columns of F are scaled to one length first:
/// then the singular values are as accurate as the data.
MatrixXd whitening(const MatrixXd& F) {
  const VectorXd lengths = F.colwise().norm().cwiseInverse();
  const quad_support::RightSingular svd(F * lengths.asDiagonal());
  const MatrixXd white =
      lengths.asDiagonal() * svd.vectors * svd.values.cwiseInverse().asDiagonal();
  return white * quad_support::SymmetricEigen(white.transpose() * white).vectors;
}

}  // namespace

QuadraticProgram::QuadraticProgram(const PredictedResponse& response, double gamma_w,
                                   const VectorXd& reference,
                                   const std::vector<PeakConstraint>& peaks)
    : p_(response.numAmplitudes()), scale_(reference.norm()), peaks_(peaks) {
  C_ = whitening(response.factor(reference));
  R_ = symmetric(gamma_w * C_.transpose() * C_);

  const Eigen::Index r = response.factors.front().rows(), n = size();
  factors_.resize(r, n * p_);
  const auto factor_of = [&](int i) { return factors_.middleCols(n * i, n); };
  for (int i = 0; i < p_; ++i)
    factor_of(i) = scale_ * response.factors[static_cast<std::size_t>(i)] * C_;
  for (int i = 0; i < p_; ++i) {
    for (int j = 0; j <= i; ++j) S_.push_back(symmetric(factor_of(i).transpose() * factor_of(j)));
  }
  if (!response.homogeneous()) {
    offset_ = response.offset * C_;
    S_00_ = symmetric(offset_.transpose() * offset_);
    for (int i = 0; i < p_; ++i) S_offset_.push_back(symmetric(offset_.transpose() * factor_of(i)));
  }
  for (PeakConstraint& peak : peaks_) {
    peak.rows *= scale_ / peak.limit;
    peak.offset /= peak.limit;
    peak.limit = 1.0;
  }
}

void QuadraticProgram::factor(const Eigen::Ref<const VectorXd>& a, MatrixXd& F) const {
  const Eigen::Index r = factors_.rows(), n = size();
  F.resize(r, n);
  Eigen::Map<VectorXd> entries(F.data(), r * n);
  entries.noalias() = Eigen::Map<const MatrixXd>(factors_.data(), r * n, p_) * a;
  if (!homogeneous()) F += offset_;
}

void QuadraticProgram::derivative(const MatrixXd& F, int i, MatrixXd& out) const {
  out.noalias() = F.transpose() * factors_.middleCols(Eigen::Index{size()} * i, size());
  addTranspose(out);
}

void QuadraticProgram::derivatives(const MatrixXd& F, MatrixXd& out) const {
  const Eigen::Index n = size();
  out.noalias() = F.transpose() * factors_;
  for (int i = 0; i < p_; ++i) addTranspose(out.middleCols(n * i, n));
}

void QuadraticProgram::H(const MatrixXd& Z, MatrixXd& out) const {
  out.resize(p_, p_);
  for (int i = 0; i < p_; ++i) {
    for (int j = 0; j <= i; ++j) out(i, j) = out(j, i) = Z.cwiseProduct(S(i, j)).sum();
  }
}

MatrixXd QuadraticProgram::N(const VectorXd& a) const {
  MatrixXd F, out;
  factor(a, F);
  N(F, out);
  return out;
}

MatrixXd QuadraticProgram::derivative(const VectorXd& a, int i) const {
  MatrixXd F, out;
  factor(a, F);
  derivative(F, i, out);
  return out;
}

MatrixXd QuadraticProgram::H(const MatrixXd& Z) const {
  MatrixXd out;
  H(Z, out);
  return out;
}

MatrixXd QuadraticProgram::toRoot(const MatrixXd& Z) const {
  return scale_ * C_ * quad_support::positiveRoot(Z);
}

MatrixXd QuadraticProgram::fromRoot(const MatrixXd& Y) const {
  const MatrixXd scaled = Eigen::PartialPivLU<MatrixXd>(C_).solve(Y) / scale_;
  return scaled * scaled.transpose();
}

}  // namespace explore_opt
