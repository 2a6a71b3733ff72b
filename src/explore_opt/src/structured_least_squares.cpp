#include "explore_opt/structured_least_squares.hpp"

#include <Eigen/QR>
#include <Eigen/SPQRSupport>
#include <Eigen/SparseCore>
#include <algorithm>

#include "checks.hpp"
#include "constants.hpp"
#include "explore_opt/set_membership.hpp"
#include "quad_support/linear_algebra.hpp"
#include "refinement.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

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
  const VectorXd of_regressors = exactScales(phi.transpose());
  VectorXd scales(static_cast<Index>(entries.size()));
  for (std::size_t e = 0; e < entries.size(); ++e)
    scales(static_cast<Index>(e)) = of_regressors(entries[e].column);
  return scales;
}

/// Entries of one row of Θ: other rows do not touch them, so sizes grow with a row, not with Θ.
std::vector<std::vector<Index>> groupByRow(const std::vector<Entry>& entries, Index nx) {
  std::vector<std::vector<Index>> groups(static_cast<std::size_t>(nx));
  for (std::size_t e = 0; e < entries.size(); ++e)
    groups[static_cast<std::size_t>(entries[e].row)].push_back(static_cast<Index>(e));
  return groups;
}

MatrixXd pick(const MatrixXd& m, const std::vector<Index>& columns) {
  MatrixXd picked(m.rows(), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    picked.col(static_cast<Index>(j)) = m.col(columns[j]);
  return picked;
}

/// Singular values of RᵀR's root with columns of length one, largest first: the union over the rows
/// of Θ.
VectorXd singularValuesOf(const MatrixXd& root, const std::vector<std::vector<Index>>& groups) {
  std::vector<double> all;
  for (const auto& group : groups) {
    if (group.empty()) continue;
    MatrixXd part = pick(root, group);
    for (Index j = 0; j < part.cols(); ++j) {
      const double length = part.col(j).norm();
      if (length > 0.0) part.col(j) /= length;
    }
    const VectorXd values = quad_support::singularValues(part);
    all.insert(all.end(), values.begin(), values.end());
  }
  std::sort(all.rbegin(), all.rend());
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Index>(all.size()));
}

void judgeExcitation(const MatrixXd& scaled_root, const std::vector<std::vector<Index>>& groups,
                     StructuredFit& fit) {
  fit.singular_values = singularValuesOf(scaled_root, groups);
  const double least = fit.singular_values.tail(1)(0);
  fit.condition = least > 0.0 ? fit.singular_values(0) / least : kInfinity;
  fit.exciting = fit.condition <= kLargestCondition;
}

/// The R of a sparse QR with its columns in the order of the regressor.
MatrixXd rootOf(const Eigen::SPQR<Sparse>& qr, Index n) {
  const MatrixXd permuted = MatrixXd(qr.matrixR()).topRows(n).triangularView<Eigen::Upper>();
  const MatrixXd root = permuted * qr.colsPermutation().inverse();
  return quad_support::triangularFactor(root);
}

/// Corrects the entries of one row of Θ and puts them there. @returns the row's residual energy
double refineRow(const VectorXd& target, const MatrixXd& phi, const std::vector<Index>& group,
                 const MatrixXd& scaled_root, const VectorXd& scales, const VectorXd& solution,
                 StructuredFit& fit) {
  if (group.empty()) return target.squaredNorm();
  const auto n = static_cast<Index>(group.size());
  MatrixXd A(phi.cols(), n);
  VectorXd start(n);
  for (Index j = 0; j < n; ++j) {
    const Index e = group[static_cast<std::size_t>(j)];
    A.col(j) = phi.row(fit.free[static_cast<std::size_t>(e)].column).transpose() / scales(e);
    start(j) = solution(e);
  }
  const MatrixXd R = quad_support::triangularFactor(pick(scaled_root, group));
  const RefinedSolution refined = refine(A, target, R, start);
  for (Index j = 0; j < n; ++j) {
    const Index e = group[static_cast<std::size_t>(j)];
    const Entry at = fit.free[static_cast<std::size_t>(e)];
    fit.Theta(at.row, at.column) = refined.solution(j, 0) / scales(e);
  }
  return refined.residual.squaredNorm();
}

/// One row of the open fit: smallest of all minimisers, triangle and residual.
void openRow(const VectorXd& target, const MatrixXd& phi, const std::vector<Index>& group,
             const VectorXd& scales, StructuredFit& fit) {
  if (group.empty()) {
    fit.residual_energy += target.squaredNorm();
    return;
  }
  const auto n = static_cast<Index>(group.size());
  const Index T = phi.cols();
  MatrixXd A = MatrixXd::Zero(std::max(T, n), n);
  for (Index j = 0; j < n; ++j) {
    const Index e = group[static_cast<std::size_t>(j)];
    A.col(j).head(T) = phi.row(fit.free[static_cast<std::size_t>(e)].column) / scales(e);
  }
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(1.0 / kLargestCondition);
  decomposition.compute(A.topRows(T));
  const VectorXd solution = decomposition.solve(target);
  const MatrixXd R = quad_support::triangularFactor(A);
  for (Index j = 0; j < n; ++j) {
    const Index e = group[static_cast<std::size_t>(j)];
    const Entry at = fit.free[static_cast<std::size_t>(e)];
    fit.Theta(at.row, at.column) = solution(j) / scales(e);
    for (Index i = 0; i < n; ++i) fit.root(group[static_cast<std::size_t>(i)], e) = R(i, j);
  }
  fit.residual_energy += (target - A.topRows(T) * solution).squaredNorm();
}

}  // namespace

StructuredFit openStructuredFit(const MatrixXd& X, const MatrixXd& U, const MatrixXd& known) {
  requireTrajectory(X, U);
  const Index nx = X.rows(), T = U.cols();
  requireShape(known, nx, nx + U.rows(), "known [A B]");
  StructuredFit fit;
  fit.free = freeEntries(known);
  const auto n = static_cast<Index>(fit.free.size());
  require(n > 0, "every entry of [A B] is known; mark those to estimate with null");

  MatrixXd phi(nx + U.rows(), T);
  phi << X.leftCols(T), U;
  const VectorXd scales = columnScales(phi, fit.free);
  fit.Theta = known.unaryExpr([](double v) { return std::isnan(v) ? 0.0 : v; });
  fit.root = MatrixXd::Zero(n, n);
  const MatrixXd target = X.rightCols(T) - fit.Theta * phi;
  const auto groups = groupByRow(fit.free, nx);
  for (Index i = 0; i < nx; ++i)
    openRow(target.row(i).transpose(), phi, groups[static_cast<std::size_t>(i)], scales, fit);
  judgeExcitation(fit.root, groups, fit);
  fit.root = fit.root * scales.asDiagonal();
  fit.information = fit.root.transpose() * fit.root;
  return fit;
}

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
  const auto groups = groupByRow(fit.free, nx);
  judgeExcitation(scaled_root, groups, fit);
  fit.root = scaled_root * scales.asDiagonal();
  fit.information = fit.root.transpose() * fit.root;
  if (!fit.exciting) return fit;

  fit.Theta = known.unaryExpr([](double v) { return std::isnan(v) ? 0.0 : v; });
  const MatrixXd target = X.rightCols(T) - fit.Theta * phi;  // x_{k+1} - (φ_kᵀ ⊗ I) c
  const VectorXd solution =
      qr.solve(VectorXd(Eigen::Map<const VectorXd>(target.data(), target.size())));
  for (Index i = 0; i < nx; ++i) {
    const auto& group = groups[static_cast<std::size_t>(i)];
    fit.residual_energy +=
        refineRow(target.row(i).transpose(), phi, group, scaled_root, scales, solution, fit);
  }
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
