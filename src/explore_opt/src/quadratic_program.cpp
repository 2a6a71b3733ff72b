#include "quadratic_program.hpp"

#include <Eigen/LU>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

Eigen::MatrixXd symmetric(const Eigen::MatrixXd& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

QuadraticProgram::QuadraticProgram(const PredictedResponse& response, double gamma_w,
                                   const Eigen::VectorXd& reference)
    : p_(response.numAmplitudes()), scale_(reference.norm()) {
  const Eigen::MatrixXd N = response.information(reference);
  const Eigen::VectorXd diagonal = N.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd slack = diagonal.asDiagonal() *
                                (N - gamma_w * Eigen::MatrixXd::Identity(N.rows(), N.cols())) *
                                diagonal.asDiagonal();
  const quad_support::SymmetricEigen eigen(symmetric(slack));
  C_ = diagonal.asDiagonal() * eigen.vectors.rowwise().reverse();
  R_ = symmetric(gamma_w * C_.transpose() * C_);

  std::vector<Eigen::MatrixXd> factors;
  for (const auto& F : response.factors) factors.push_back(scale_ * F * C_);
  S_.resize(static_cast<std::size_t>(p_) * static_cast<std::size_t>(p_));
  for (int a = 0; a < p_; ++a) {
    for (int b = 0; b <= a; ++b) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b),
                 n = static_cast<std::size_t>(p_);
      S_[i * n + j] = S_[j * n + i] = symmetric(factors[i].transpose() * factors[j]);
    }
  }
}

Eigen::MatrixXd QuadraticProgram::N(const Eigen::VectorXd& a) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size(), size());
  for (int i = 0; i < p_; ++i) {
    sum += a(i) * a(i) * S(i, i);
    for (int j = 0; j < i; ++j) sum += 2.0 * a(i) * a(j) * S(i, j);
  }
  return sum;
}

Eigen::MatrixXd QuadraticProgram::derivative(const Eigen::VectorXd& a, int i) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size(), size());
  for (int j = 0; j < p_; ++j) sum += 2.0 * a(j) * S(i, j);
  return sum;
}

Eigen::MatrixXd QuadraticProgram::H(const Eigen::MatrixXd& Z) const {
  Eigen::MatrixXd h(p_, p_);
  for (int i = 0; i < p_; ++i) {
    for (int j = 0; j <= i; ++j) h(i, j) = h(j, i) = Z.cwiseProduct(S(i, j)).sum();
  }
  return h;
}

Eigen::MatrixXd QuadraticProgram::toCertificate(const Eigen::MatrixXd& Z) const {
  return symmetric(scale_ * scale_ * C_ * Z * C_.transpose());
}

Eigen::MatrixXd QuadraticProgram::fromCertificate(const Eigen::MatrixXd& Z) const {
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(C_);
  const Eigen::MatrixXd half = lu.solve(Z);  // C⁻¹ Z
  return symmetric(lu.solve(half.transpose())) / (scale_ * scale_);
}

}  // namespace explore_opt
