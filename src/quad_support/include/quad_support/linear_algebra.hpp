/// Eigenvalues, singular values and triangles of matrices of any size, compiled once: the templates
/// behind them take longer to compile than the rest of a file that uses them.
#pragma once

#include <Eigen/Core>

namespace quad_support {

/// Up to this many rows and columns the functions that write into the caller's memory work on the
/// stack: a full D_des of three states and three inputs is 18 x 18, and a matrix takes 4.5 KiB.
constexpr int kStackOrder = 24;

/// m = V diag(values) Vᵀ of a symmetric m (its lower triangle is read); values ascend, columns of V
/// are orthonormal.
struct SymmetricEigen {
  explicit SymmetricEigen(const Eigen::MatrixXd& m);
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// The same into memory that the caller keeps, without heap up to kStackOrder.
void symmetricEigen(const Eigen::MatrixXd& m, Eigen::VectorXd& values, Eigen::MatrixXd& vectors);

/// The eigenvalues alone, ascending; faster than SymmetricEigen.
Eigen::VectorXd symmetricEigenvalues(const Eigen::MatrixXd& m);

/// The first of them, without heap up to kStackOrder.
double smallestEigenvalue(const Eigen::MatrixXd& m);

/// m^{-1/2}, the symmetric root, of a symmetric positive definite m.
Eigen::MatrixXd inverseSquareRoot(const Eigen::MatrixXd& m);

/// Y with Y Yᵀ the positive part of a symmetric m; as many columns as it has positive eigenvalues.
Eigen::MatrixXd positiveRoot(const Eigen::MatrixXd& m);

/// The largest magnitude of an eigenvalue of a square m.
double spectralRadius(const Eigen::MatrixXd& m);

/// R of m = QR, upper triangular, min(rows, cols) x cols; RᵀR = mᵀm. Diagonal of any sign.
Eigen::MatrixXd triangularFactor(const Eigen::MatrixXd& m);

/// Singular values of m, descending, to full relative accuracy of the largest (one-sided Jacobi).
Eigen::VectorXd singularValues(const Eigen::MatrixXd& m);

/// Singular values, descending, and left singular vectors of a square m, into memory that the
/// caller keeps, without heap up to kStackOrder.
void leftSingular(const Eigen::MatrixXd& m, Eigen::VectorXd& values, Eigen::MatrixXd& vectors);

/// Singular values of m, descending, and as many right singular vectors.
struct RightSingular {
  explicit RightSingular(const Eigen::MatrixXd& m);
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// All left singular vectors (rows x rows), in the order of singularValues().
Eigen::MatrixXd leftSingularVectors(const Eigen::MatrixXd& m);

}  // namespace quad_support
