#include "quad_support/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

namespace quad_support {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using StackMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                  kStackOrder, kStackOrder>;

bool fitsStack(const MatrixXd& m) { return m.rows() <= kStackOrder && m.cols() <= kStackOrder; }

template <typename Matrix>
void eigenOf(const MatrixXd& m, VectorXd& values, MatrixXd& vectors) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(m);
  values = solver.eigenvalues();
  vectors = solver.eigenvectors();
}

// A square m needs no QR before Jacobi's rotations; saying so spares the compiler half the work.
template <typename Matrix>
void leftSingularOf(const MatrixXd& m, VectorXd& values, MatrixXd& vectors) {
  const Eigen::JacobiSVD<Matrix, Eigen::NoQRPreconditioner> solver(m, Eigen::ComputeFullU);
  values = solver.singularValues();
  vectors = solver.matrixU();
}

}  // namespace

void symmetricEigen(const MatrixXd& m, VectorXd& values, MatrixXd& vectors) {
  return fitsStack(m) ? eigenOf<StackMatrix>(m, values, vectors)
                      : eigenOf<MatrixXd>(m, values, vectors);
}

SymmetricEigen::SymmetricEigen(const MatrixXd& m) { symmetricEigen(m, values, vectors); }

double smallestEigenvalue(const MatrixXd& m) {
  if (!fitsStack(m)) return symmetricEigenvalues(m)(0);
  return Eigen::SelfAdjointEigenSolver<StackMatrix>(m, Eigen::EigenvaluesOnly).eigenvalues()(0);
}

void leftSingular(const MatrixXd& m, VectorXd& values, MatrixXd& vectors) {
  return fitsStack(m) ? leftSingularOf<StackMatrix>(m, values, vectors)
                      : leftSingularOf<MatrixXd>(m, values, vectors);
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

double spectralRadius(const MatrixXd& m) { return m.eigenvalues().cwiseAbs().maxCoeff(); }

MatrixXd triangularFactor(const MatrixXd& m) {
  const Eigen::HouseholderQR<MatrixXd> qr(m);
  return qr.matrixQR().topRows(std::min(m.rows(), m.cols())).triangularView<Eigen::Upper>();
}

VectorXd singularValues(const MatrixXd& m) {
  return Eigen::JacobiSVD<MatrixXd>(m).singularValues();
}

RightSingular::RightSingular(const MatrixXd& m) {
  const Eigen::JacobiSVD<MatrixXd> solver(m, Eigen::ComputeThinV);
  values = solver.singularValues();
  vectors = solver.matrixV();
}

MatrixXd leftSingularVectors(const MatrixXd& m) {
  return Eigen::JacobiSVD<MatrixXd>(m, Eigen::ComputeFullU).matrixU();
}

}  // namespace quad_support
