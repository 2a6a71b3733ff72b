#include "quadratic_program.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd symmetric(const MatrixXd& m) { return 0.5 * (m + m.transpose()); }

/// C with (F C)ᵀ F C = I and CᵀC diagonal, ascending. Columns of F are scaled to one length first:
/// then the singular values are as accurate as the data.
MatrixXd whitening(const MatrixXd& F) {
  const VectorXd lengths = F.colwise().norm().cwiseInverse();
  const Eigen::JacobiSVD<MatrixXd> svd(F * lengths.asDiagonal(), Eigen::ComputeThinV);
  const MatrixXd white =
      lengths.asDiagonal() * svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal();
  return white * quad_support::SymmetricEigen(white.transpose() * white).vectors;
}

}  // namespace

QuadraticProgram::QuadraticProgram(const PredictedResponse& response, double gamma_w,
                                   const VectorXd& reference,
                                   const std::vector<PeakConstraint>& peaks)
    : p_(response.numAmplitudes()), scale_(reference.norm()), peaks_(peaks) {
  C_ = whitening(response.factor(reference));
  R_ = symmetric(gamma_w * C_.transpose() * C_);

  std::vector<MatrixXd> factors;
  for (const auto& F : response.factors) factors.push_back(scale_ * F * C_);
  for (std::size_t a = 0; a < factors.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b)
      S_.push_back(symmetric(factors[a].transpose() * factors[b]));
  }
  if (!response.homogeneous()) {
    const MatrixXd offset = response.offset * C_;
    S_00_ = symmetric(offset.transpose() * offset);
    for (const MatrixXd& F : factors) S_offset_.push_back(symmetric(offset.transpose() * F));
  }
  for (PeakConstraint& peak : peaks_) {
    peak.rows *= scale_ / peak.limit;
    peak.offset /= peak.limit;
    peak.limit = 1.0;
  }
}

MatrixXd QuadraticProgram::N(const VectorXd& a) const {
  MatrixXd sum = homogeneous() ? MatrixXd::Zero(size(), size()) : S_00_;
  for (int i = 0; i < p_; ++i) {
    if (!homogeneous()) sum += 2.0 * a(i) * S_0(i);
    sum += a(i) * a(i) * S(i, i);
    for (int j = 0; j < i; ++j) sum += 2.0 * a(i) * a(j) * S(i, j);
  }
  return sum;
}

MatrixXd QuadraticProgram::derivative(const VectorXd& a, int i) const {
  MatrixXd sum = homogeneous() ? MatrixXd::Zero(size(), size()) : MatrixXd(2.0 * S_0(i));
  for (int j = 0; j < p_; ++j) sum += 2.0 * a(j) * S(i, j);
  return sum;
}

MatrixXd QuadraticProgram::H(const MatrixXd& Z) const {
  MatrixXd h(p_, p_);
  for (int i = 0; i < p_; ++i) {
    for (int j = 0; j <= i; ++j) h(i, j) = h(j, i) = Z.cwiseProduct(S(i, j)).sum();
  }
  return h;
}

MatrixXd QuadraticProgram::toRoot(const MatrixXd& Z) const {
  return scale_ * C_ * quad_support::positiveRoot(Z);
}

MatrixXd QuadraticProgram::fromRoot(const MatrixXd& Y) const {
  const MatrixXd scaled = Eigen::PartialPivLU<MatrixXd>(C_).solve(Y) / scale_;
  return scaled * scaled.transpose();
}

}  // namespace explore_opt
