#include "factor_program.hpp"

#include <Eigen/QR>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {

using Eigen::MatrixXd;
using Eigen::VectorXd;

FactorProgram::FactorProgram(const QuadraticProgram& program)
    : program_(program),
      p_(program.numAmplitudes()),
      n_(program.size()),
      triangle_(n_ * (n_ + 1) / 2) {}

MatrixXd FactorProgram::lowerOf(const VectorXd& x) const {
  MatrixXd L = MatrixXd::Zero(n_, n_);
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) L(i, j) = x(p_ + at(i, j));
  }
  return L;
}

bool FactorProgram::objective(const VectorXd& x, double& f) {
  f = 0.5 * x.head(p_).squaredNorm();
  return true;
}

bool FactorProgram::gradient(const VectorXd& x, VectorXd& g) {
  g.setZero();
  g.head(p_) = x.head(p_);
  return true;
}

void FactorProgram::constraints(const VectorXd& x, VectorXd& c) {
  const MatrixXd L = lowerOf(x);
  const MatrixXd difference = program_.N(x.head(p_)) - program_.rightSide() - L * L.transpose();
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) c(at(i, j)) = difference(i, j);
  }
}

Positions FactorProgram::jacobianPositions() const {
  Positions positions;
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (int a = 0; a < p_; ++a) positions.emplace_back(at(i, j), a);
      for (int k = 0; k <= j; ++k) {  // (L Lᵀ)_ij = Σ_k L_ik L_jk
        positions.emplace_back(at(i, j), p_ + at(i, k));
        if (i != j) positions.emplace_back(at(i, j), p_ + at(j, k));
      }
    }
  }
  return positions;
}

void FactorProgram::jacobian(const VectorXd& x, VectorXd& values) {
  std::vector<MatrixXd> slopes;
  for (int a = 0; a < p_; ++a) slopes.push_back(program_.derivative(x.head(p_), a));
  const MatrixXd L = lowerOf(x);
  int next = 0;
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (const MatrixXd& slope : slopes) values(next++) = slope(i, j);
      for (int k = 0; k <= j; ++k) {
        values(next++) = i != j ? -L(j, k) : -2.0 * L(i, k);
        if (i != j) values(next++) = -L(i, k);
      }
    }
  }
}

Positions FactorProgram::hessianPositions() const {
  Positions positions;
  for (int a = 0; a < p_; ++a) {
    for (int b = 0; b <= a; ++b) positions.emplace_back(a, b);
  }
  for (int j = 0; j < n_; ++j) {  // L_ij meets L_kj only
    for (int i = j; i < n_; ++i) {
      for (int k = j; k <= i; ++k) positions.emplace_back(p_ + at(i, j), p_ + at(k, j));
    }
  }
  return positions;
}

bool FactorProgram::hessian(const VectorXd&, double weight, const VectorXd& multipliers,
                            VectorXd& values) {
  const MatrixXd Lambda = -certificateOf(multipliers);
  const MatrixXd H = program_.H(Lambda);
  int next = 0;
  for (int a = 0; a < p_; ++a) {
    for (int b = 0; b <= a; ++b) values(next++) = 2.0 * H(a, b) + (a == b ? weight : 0.0);
  }
  for (int j = 0; j < n_; ++j) {
    for (int i = j; i < n_; ++i) {
      for (int k = j; k <= i; ++k) values(next++) = -2.0 * Lambda(i, k);
    }
  }
  return true;
}

VectorXd FactorProgram::startAt(const VectorXd& a) const {
  // L Lᵀ = V max(D, 0) Vᵀ: the triangle of a QR of the root, transposed.
  const quad_support::SymmetricEigen eigen(program_.N(a) - program_.rightSide());
  const VectorXd roots = eigen.values.cwiseMax(0.0).cwiseSqrt();
  const MatrixXd root = roots.asDiagonal() * eigen.vectors.transpose();
  const MatrixXd U = Eigen::HouseholderQR<MatrixXd>(root).matrixQR().triangularView<Eigen::Upper>();
  VectorXd x(numVariables());
  x.head(p_) = a;
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) x(p_ + at(i, j)) = U(j, j) < 0.0 ? -U(j, i) : U(j, i);
  }
  return x;
}

MatrixXd FactorProgram::certificateOf(const VectorXd& multipliers) const {
  MatrixXd Z(n_, n_);
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) Z(i, j) = Z(j, i) = (i == j ? -1.0 : -0.5) * multipliers(at(i, j));
  }
  return Z;
}

VectorXd FactorProgram::multipliersOf(const MatrixXd& Z) const {
  VectorXd multipliers(triangle_);
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) multipliers(at(i, j)) = (i == j ? -1.0 : -2.0) * Z(i, j);
  }
  return multipliers;
}

}  // namespace explore_opt
