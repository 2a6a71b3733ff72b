#include "quad_support/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace quad_support {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricEigen::SymmetricEigen(const MatrixXd& m) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(m);
  values = solver.eigenvalues();
  vectors = solver.eigenvectors();
}

VectorXd symmetricEigenvalues(const MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

MatrixXd inverseSquareRoot(const MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(m).operatorInverseSqrt();
}

MatrixXd positiveRoot(const MatrixXd& m) {
  const SymmetricEigen eigen(m);
  const Eigen::Index count = (eigen.values.array() > 0.0).count();  // the last ones
  return eigen.vectors.rightCols(count) * eigen.values.tail(count).cwiseSqrt().asDiagonal();
}

VectorXd singularValues(const MatrixXd& m) {
  return Eigen::JacobiSVD<MatrixXd>(m).singularValues();
}

MatrixXd leftSingularVectors(const MatrixXd& m) {
  return Eigen::JacobiSVD<MatrixXd>(m, Eigen::ComputeFullU).matrixU();
}

}  // namespace quad_support
