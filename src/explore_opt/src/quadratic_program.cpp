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

void QuadraticProgram::N(const Eigen::Ref<const VectorXd>& a, MatrixXd& out) const {
  if (homogeneous())
    out.setZero(size(), size());
  else
    out = S_00_;
  for (int i = 0; i < p_; ++i) {
    if (!homogeneous()) out += 2.0 * a(i) * S_0(i);
    out += a(i) * a(i) * S(i, i);
    for (int j = 0; j < i; ++j) out += 2.0 * a(i) * a(j) * S(i, j);
  }
}

void QuadraticProgram::derivative(const Eigen::Ref<const VectorXd>& a, int i, MatrixXd& out) const {
  if (homogeneous())
    out.setZero(size(), size());
  else
    out = 2.0 * S_0(i);
  for (int j = 0; j < p_; ++j) out += 2.0 * a(j) * S(i, j);
}

void QuadraticProgram::H(const MatrixXd& Z, MatrixXd& out) const {
  out.resize(p_, p_);
  for (int i = 0; i < p_; ++i) {
    for (int j = 0; j <= i; ++j) out(i, j) = out(j, i) = Z.cwiseProduct(S(i, j)).sum();
  }
}

MatrixXd QuadraticProgram::N(const VectorXd& a) const {
  MatrixXd out;
  N(a, out);
  return out;
}

MatrixXd QuadraticProgram::derivative(const VectorXd& a, int i) const {
  MatrixXd out;
  derivative(a, i, out);
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
