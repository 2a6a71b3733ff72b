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
}

MatrixXd BarrierProgram::slack(const VectorXd& a) const {
  MatrixXd S = F0_;
  for (int i = 0; i < numVariables(); ++i) S += a(i) * F_[static_cast<std::size_t>(i)];
  return S;
}

bool BarrierProgram::objective(const VectorXd& a, double& f) {
  const Eigen::LLT<MatrixXd> llt(slack(a));
  if (llt.info() != Eigen::Success) return false;
  f = 0.5 * a.squaredNorm() -
      2.0 * mu_ * llt.matrixL().toDenseMatrix().diagonal().array().log().sum();
  return std::isfinite(f);
}

bool BarrierProgram::gradient(const VectorXd& a, VectorXd& g) {
  const Eigen::LLT<MatrixXd> llt(slack(a));
  if (llt.info() != Eigen::Success) return false;
  for (int i = 0; i < numVariables(); ++i)
    g(i) = a(i) - mu_ * llt.solve(F_[static_cast<std::size_t>(i)]).trace();
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
  const Eigen::LLT<MatrixXd> llt(slack(a));
  if (llt.info() != Eigen::Success) return false;
  std::vector<MatrixXd> whitened;  // L⁻¹ F_i L⁻ᵀ: their products are tr(S⁻¹ F_i S⁻¹ F_j)
  for (const MatrixXd& F : F_) {
    const MatrixXd half = llt.matrixL().solve(F);
    whitened.push_back(llt.matrixL().solve(half.transpose()));
  }
  int next = 0;
  for (std::size_t i = 0; i < F_.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      values(next++) =
          weight * (mu_ * whitened[i].cwiseProduct(whitened[j]).sum() + (i == j ? 1.0 : 0.0));
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
