#include "factor_program.hpp"

#include <algorithm>
#include <cmath>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {

using Eigen::MatrixXd;
using Eigen::VectorXd;

FactorProgram::FactorProgram(const QuadraticProgram& program)
    : program_(program),
      p_(program.numAmplitudes()),
      n_(program.size()),
      triangle_(n_ * (n_ + 1) / 2),
      peaks_(static_cast<int>(program.peaks().size())),
      L_(MatrixXd::Zero(n_, n_)),
      difference_(n_, n_),
      Lambda_(n_, n_),
      H_(p_, p_),
      slopes_(static_cast<std::size_t>(p_), MatrixXd(n_, n_)) {}

void FactorProgram::readLower(const VectorXd& x) {
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) L_(i, j) = x(p_ + at(i, j));
  }
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
  readLower(x);
  program_.factor(x.head(p_), F_);
  program_.N(F_, difference_);
  difference_ -= program_.rightSide();
  difference_.noalias() -= L_ * L_.transpose();
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) c(at(i, j)) = difference_(i, j);
  }
  for (int k = 0; k < peaks_; ++k)
    c(triangle_ + k) = program_.peaks()[static_cast<std::size_t>(k)].room(x.head(p_));
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
  for (int k = 0; k < peaks_; ++k) {
    for (int a = 0; a < p_; ++a) positions.emplace_back(triangle_ + k, a);
  }
  return positions;
}

void FactorProgram::jacobian(const VectorXd& x, VectorXd& values) {
  program_.factor(x.head(p_), F_);
  for (int a = 0; a < p_; ++a) program_.derivative(F_, a, slopes_[static_cast<std::size_t>(a)]);
  readLower(x);
  int next = 0;
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) {
      for (const MatrixXd& slope : slopes_) values(next++) = slope(i, j);
      for (int k = 0; k <= j; ++k) {
        values(next++) = i != j ? -L_(j, k) : -2.0 * L_(i, k);
        if (i != j) values(next++) = -L_(i, k);
      }
    }
  }
  for (int k = 0; k < peaks_; ++k) {
    const PeakConstraint& peak = program_.peaks()[static_cast<std::size_t>(k)];
    auto slope = values.segment(next, p_);
    slope.setZero();
    for (Eigen::Index r = 0; r < peak.rows.rows(); ++r)
      slope -= 2.0 * peak.value(r, x.head(p_)) * peak.rows.row(r).transpose();
    next += p_;
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
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j)
      Lambda_(i, j) = Lambda_(j, i) = (i == j ? 1.0 : 0.5) * multipliers(at(i, j));
  }
  program_.H(Lambda_, H_);
  for (int k = 0; k < peaks_; ++k) {
    const MatrixXd& Q = program_.peaks()[static_cast<std::size_t>(k)].rows;
    for (Eigen::Index r = 0; r < Q.rows(); ++r) {
      for (int a = 0; a < p_; ++a)
        H_.col(a) -= multipliers(triangle_ + k) * Q(r, a) * Q.row(r).transpose();
    }
  }
  int next = 0;
  for (int a = 0; a < p_; ++a) {
    for (int b = 0; b <= a; ++b) values(next++) = 2.0 * H_(a, b) + (a == b ? weight : 0.0);
  }
  for (int j = 0; j < n_; ++j) {
    for (int i = j; i < n_; ++i) {
      for (int k = j; k <= i; ++k) values(next++) = -2.0 * Lambda_(i, k);
    }
  }
  return true;
}

VectorXd FactorProgram::startAt(const VectorXd& a) const {
  // L Lᵀ = V max(D, 0) Vᵀ: the triangle of a QR of the root, transposed.
  const quad_support::SymmetricEigen eigen(program_.N(a) - program_.rightSide());
  const VectorXd roots = eigen.values.cwiseMax(0.0).cwiseSqrt();
  const MatrixXd root = roots.asDiagonal() * eigen.vectors.transpose();
  const MatrixXd U = quad_support::triangularFactor(root);
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

VectorXd FactorProgram::multipliersOf(const MatrixXd& Z, const VectorXd& nu) const {
  VectorXd multipliers(triangle_ + peaks_);
  multipliers.tail(peaks_) = -0.5 * nu;
  for (int i = 0; i < n_; ++i) {
    for (int j = 0; j <= i; ++j) multipliers(at(i, j)) = (i == j ? -1.0 : -2.0) * Z(i, j);
  }
  return multipliers;
}

VectorXd FactorProgram::peakMultipliersOf(const VectorXd& multipliers) const {
  return -2.0 * multipliers.tail(peaks_);
}

}  // namespace explore_opt
