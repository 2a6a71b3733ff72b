#include "barrier_program.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace explore_opt {

using Eigen::MatrixXd;
using Eigen::VectorXd;

BarrierProgram::BarrierProgram(const QuadraticProgram& program, const VectorXd& candidate)
    : F0_(program.N(candidate) - program.rightSide()) {
  for (int i = 0; i < program.numAmplitudes(); ++i) {
    F_.push_back(program.derivative(candidate, i));
    F0_ -= candidate(i) * F_.back();
  }
  whitened_ = F_;
}

void BarrierProgram::slack(const VectorXd& a, MatrixXd& out) const {
  out = F0_;
  for (int i = 0; i < numVariables(); ++i) out += a(i) * F_[static_cast<std::size_t>(i)];
}

MatrixXd BarrierProgram::slack(const VectorXd& a) const {
  MatrixXd S;
  slack(a, S);
  return S;
}

bool BarrierProgram::factorise(const VectorXd& a) {
  slack(a, S_);
  llt_.compute(S_);
  return llt_.info() == Eigen::Success;
}

bool BarrierProgram::objective(const VectorXd& a, double& f) {
  if (!factorise(a)) return false;
  f = 0.5 * a.squaredNorm() - 2.0 * mu_ * llt_.matrixLLT().diagonal().array().log().sum();
  return std::isfinite(f);
}

bool BarrierProgram::gradient(const VectorXd& a, VectorXd& g) {
  if (!factorise(a)) return false;
  for (int i = 0; i < numVariables(); ++i) {
    half_ = F_[static_cast<std::size_t>(i)];
    llt_.solveInPlace(half_);
    g(i) = a(i) - mu_ * half_.trace();
  }
  return true;
}

Positions BarrierProgram::hessianPositions() const {
  Positions positions;
  for (int i = 0; i < numVariables(); ++i) {
    for (int j = 0; j <= i; ++j) positions.emplace_back(i, j);
  }
  return positions;
}

bool BarrierProgram::hessian(const VectorXd& a, double weight, const VectorXd&, VectorXd& values) {
  if (!factorise(a)) return false;
  for (std::size_t i = 0; i < F_.size();
       ++i) {  // L⁻¹ F_i L⁻ᵀ: their products are tr(S⁻¹ F_i S⁻¹ F_j)
    half_ = F_[i];
    llt_.matrixL().solveInPlace(half_);
    whitened_[i] = half_.transpose();
    llt_.matrixL().solveInPlace(whitened_[i]);
  }
  int next = 0;
  for (std::size_t i = 0; i < F_.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      values(next++) =
          weight * (mu_ * whitened_[i].cwiseProduct(whitened_[j]).sum() + (i == j ? 1.0 : 0.0));
    }
  }
  return true;
}

MatrixXd BarrierProgram::certificate(const VectorXd& a) const {
  const MatrixXd S = slack(a);
  return mu_ * S.llt().solve(MatrixXd::Identity(S.rows(), S.cols()));
}

double BarrierProgram::gap(const VectorXd& a) const {
  const MatrixXd Z = certificate(a);
  double miss = 0.0;
  for (int i = 0; i < numVariables(); ++i) {
    const double difference = a(i) - Z.cwiseProduct(F_[static_cast<std::size_t>(i)]).sum();
    miss += difference * difference;
  }
  return Z.cwiseProduct(slack(a)).sum() + 0.5 * miss;
}

}  // namespace explore_opt
