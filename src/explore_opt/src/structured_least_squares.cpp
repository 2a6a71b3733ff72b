#include "explore_opt/structured_least_squares.hpp"

#include <Eigen/QR>
#include <Eigen/SPQRSupport>
#include <Eigen/SparseCore>
#include <limits>

#include "checks.hpp"
#include "explore_opt/set_membership.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kLargestCondition = 1e10;

std::vector<Entry> freeEntries(const MatrixXd& known) {
  std::vector<Entry> entries;
  for (Index j = 0; j < known.cols(); ++j) {
    for (Index i = 0; i < known.rows(); ++i) {
      if (std::isnan(known(i, j))) {
        entries.push_back({static_cast<int>(i), static_cast<int>(j)});
      } else {
        require(std::isfinite(known(i, j)), "known({}, {}) is infinite (indices from 0)", i, j);
      }
    }
  }
  return entries;
}

/// Rows of (φ_kᵀ ⊗ I) E for all k, columns divided by `scales`.
Sparse regressor(const MatrixXd& phi, Index nx, const std::vector<Entry>& entries,
                 const VectorXd& scales) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const auto column = static_cast<Index>(e);
    for (Index k = 0; k < phi.cols(); ++k) {
      triplets.emplace_back(k * nx + entries[e].row, column,
                            phi(entries[e].column, k) / scales(column));
    }
  }
  Sparse matrix(phi.cols() * nx, static_cast<Index>(entries.size()));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

VectorXd columnScales(const MatrixXd& phi, const std::vector<Entry>& entries) {
  VectorXd scales(static_cast<Index>(entries.size()));
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const double length = phi.row(entries[e].column).norm();
    scales(static_cast<Index>(e)) = length > 0.0 ? length : 1.0;
  }
  return scales;
}

/// The R of a sparse QR with its columns in the order of the regressor.
MatrixXd rootOf(const Eigen::SPQR<Sparse>& qr, Index n) {
  const MatrixXd permuted = MatrixXd(qr.matrixR()).topRows(n).triangularView<Eigen::Upper>();
  const MatrixXd root = permuted * qr.colsPermutation().inverse();
  return Eigen::HouseholderQR<MatrixXd>(root).matrixQR().triangularView<Eigen::Upper>();
}

}  // namespace

StructuredFit fitStructured(const MatrixXd& X, const MatrixXd& U, const MatrixXd& known) {
  requireTrajectory(X, U);
  const Index nx = X.rows(), T = U.cols();
  requireShape(known, nx, nx + U.rows(), "known [A B]");
  StructuredFit fit;
  fit.free = freeEntries(known);
  const auto n = static_cast<Index>(fit.free.size());
  require(n > 0, "every entry of [A B] is known; mark those to estimate with null");
  require(T * nx >= n, "{} equations for {} unknown entries; more samples are needed", T * nx, n);

  MatrixXd phi(nx + U.rows(), T);
  phi << X.leftCols(T), U;
  const VectorXd scales = columnScales(phi, fit.free);
  Sparse matrix = regressor(phi, nx, fit.free, scales);
  matrix.makeCompressed();
  const Eigen::SPQR<Sparse> qr(matrix);
  require(qr.info() == Eigen::Success, "sparse QR failed");
  const MatrixXd scaled_root = rootOf(qr, n);
  fit.singular_values = quad_support::singularValues(scaled_root);
  const double least = fit.singular_values(n - 1);
  fit.condition =
      least > 0.0 ? fit.singular_values(0) / least : std::numeric_limits<double>::infinity();
  fit.exciting = fit.condition <= kLargestCondition;
  fit.root = scaled_root * scales.asDiagonal();
  fit.information = fit.root.transpose() * fit.root;
  if (!fit.exciting) return fit;

  fit.Theta = known.unaryExpr([](double v) { return std::isnan(v) ? 0.0 : v; });
  const MatrixXd target = X.rightCols(T) - fit.Theta * phi;  // x_{k+1} - (φ_kᵀ ⊗ I) c
  const VectorXd solution =
      qr.solve(VectorXd(Eigen::Map<const VectorXd>(target.data(), target.size())));
  for (Index e = 0; e < n; ++e) {
    const Entry at = fit.free[static_cast<std::size_t>(e)];
    fit.Theta(at.row, at.column) = solution(e) / scales(e);
  }
  fit.residual_energy = (X.rightCols(T) - fit.Theta * phi).squaredNorm();
  return fit;
}

MatrixXd restrictCloseness(const MatrixXd& closeness, const StructuredFit& fit) {
  const auto nx = fit.Theta.rows();
  const MatrixXd full =
      fullCloseness(closeness, static_cast<int>(nx), static_cast<int>(fit.Theta.cols()));
  const auto n = static_cast<Index>(fit.free.size());
  MatrixXd restricted(n, n);
  for (Index a = 0; a < n; ++a) {
    for (Index b = 0; b < n; ++b) {
      const Entry i = fit.free[static_cast<std::size_t>(a)],
                  j = fit.free[static_cast<std::size_t>(b)];
      restricted(a, b) = full(i.column * nx + i.row, j.column * nx + j.row);
    }
  }
  return restricted;
}

}  // namespace explore_opt
