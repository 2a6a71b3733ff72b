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
        require(std::isfinite(known(i, j)), "known: row {}, column {} is infinite", i + 1, j + 1);
      }
    }
  }
  return entries;
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

/// The equations x_{k+1} - (φ_kᵀ ⊗ I) c = (φ_kᵀ ⊗ I) E ϑ.
struct Regression {
  MatrixXd phi;     // φ_k = (x_k, u_k), n_φ x T
  MatrixXd target;  // left-hand sides, n_x x T
  VectorXd scales;  // of the columns, powers of two, one for each free entry
  std::vector<std::vector<Index>> groups;
};

/// Checks the data, and begins the fit: its free entries, and in Theta the known ones (c).
Regression regression(const MatrixXd& X, const MatrixXd& U, const MatrixXd& known,
                      StructuredFit& fit) {
  requireTrajectory(X, U);
  const Index nx = X.rows(), T = U.cols();
  requireShape(known, nx, nx + U.rows(), "known [A B]");
  fit.free = freeEntries(known);
  require(!fit.free.empty(), "every entry of [A B] is known; mark those to estimate with null");
  fit.Theta = known.unaryExpr([](double v) { return std::isnan(v) ? 0.0 : v; });
  Regression r;
  r.phi.resize(nx + U.rows(), T);
  r.phi << X.leftCols(T), U;
  r.target = X.rightCols(T) - fit.Theta * r.phi;
  r.scales = columnScales(r.phi, fit.free);
  r.groups = groupByRow(fit.free, nx);
  return r;
}

/// Rows of (φ_kᵀ ⊗ I) E for all k, columns divided by their scales.
Sparse sparseRegressor(const Regression& r, Index nx, const std::vector<Entry>& free) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t e = 0; e < free.size(); ++e) {
    const auto column = static_cast<Index>(e);
    for (Index k = 0; k < r.phi.cols(); ++k) {
      triplets.emplace_back(k * nx + free[e].row, column,
                            r.phi(free[e].column, k) / r.scales(column));
    }
  }
  Sparse matrix(r.phi.cols() * nx, static_cast<Index>(free.size()));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
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

/// Singular values, condition and verdict, of the root of the regressor with scaled columns.
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

/// Scaled regressors of one row of Θ, T x the number of its free entries.
MatrixXd regressorOfRow(const Regression& r, const std::vector<Index>& group,
                        const std::vector<Entry>& free) {
  MatrixXd A(r.phi.cols(), static_cast<Index>(group.size()));
  for (std::size_t j = 0; j < group.size(); ++j) {
    const int column = free[static_cast<std::size_t>(group[j])].column;
    A.col(static_cast<Index>(j)) = r.phi.row(column).transpose() / r.scales(group[j]);
  }
  return A;
}

/// Puts the scaled entries of one row of Θ where they belong.
void putRow(const Regression& r, const std::vector<Index>& group, const VectorXd& solution,
            StructuredFit& fit) {
  for (std::size_t j = 0; j < group.size(); ++j) {
    const Entry at = fit.free[static_cast<std::size_t>(group[j])];
    fit.Theta(at.row, at.column) = solution(static_cast<Index>(j)) / r.scales(group[j]);
  }
}

/// Corrects the entries of row i of Θ, puts them there and adds the row's residual energy.
void refineRow(const Regression& r, Index i, const MatrixXd& scaled_root, const VectorXd& solution,
               StructuredFit& fit) {
  const std::vector<Index>& group = r.groups[static_cast<std::size_t>(i)];
  const VectorXd target = r.target.row(i).transpose();
  if (group.empty()) {
    fit.residual_energy += target.squaredNorm();
    return;
  }
  const MatrixXd R = quad_support::triangularFactor(pick(scaled_root, group));
  const RefinedSolution refined =
      refine(regressorOfRow(r, group, fit.free), target, R, solution(group));
  putRow(r, group, refined.solution, fit);
  fit.residual_energy += refined.residual.squaredNorm();
}

/// Row i of the open fit: smallest of all minimisers, triangle and residual.
void openRow(const Regression& r, Index i, StructuredFit& fit) {
  const std::vector<Index>& group = r.groups[static_cast<std::size_t>(i)];
  const VectorXd target = r.target.row(i).transpose();
  if (group.empty()) {
    fit.residual_energy += target.squaredNorm();
    return;
  }
  const MatrixXd A = regressorOfRow(r, group, fit.free);
  const Index n = A.cols();
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(1.0 / kLargestCondition);
  decomposition.compute(A);
  const VectorXd solution = decomposition.solve(target);
  MatrixXd tall = MatrixXd::Zero(std::max(A.rows(), n), n);  // with fewer samples than entries, too
  tall.topRows(A.rows()) = A;
  fit.root(group, group) = quad_support::triangularFactor(tall);
  putRow(r, group, solution, fit);
  fit.residual_energy += (target - A * solution).squaredNorm();
}

}  // namespace

StructuredFit openStructuredFit(const MatrixXd& X, const MatrixXd& U, const MatrixXd& known) {
  StructuredFit fit;
  const Regression r = regression(X, U, known, fit);
  const auto n = static_cast<Index>(fit.free.size());
  fit.root = MatrixXd::Zero(n, n);
  for (Index i = 0; i < X.rows(); ++i) openRow(r, i, fit);
  judgeExcitation(fit.root, r.groups, fit);
  fit.root = fit.root * r.scales.asDiagonal();
  fit.information = fit.root.transpose() * fit.root;
  return fit;
}

StructuredFit fitStructured(const MatrixXd& X, const MatrixXd& U, const MatrixXd& known) {
  StructuredFit fit;
  const Regression r = regression(X, U, known, fit);
  const Index nx = X.rows(), T = U.cols();
  const auto n = static_cast<Index>(fit.free.size());
  require(T * nx >= n, "{} equations for {} unknown entries; more samples are needed", T * nx, n);

  Sparse matrix = sparseRegressor(r, nx, fit.free);
  matrix.makeCompressed();
  const Eigen::SPQR<Sparse> qr(matrix);
  require(qr.info() == Eigen::Success, "sparse QR failed");
  const MatrixXd scaled_root = rootOf(qr, n);
  judgeExcitation(scaled_root, r.groups, fit);
  fit.root = scaled_root * r.scales.asDiagonal();
  fit.information = fit.root.transpose() * fit.root;
  if (!fit.exciting) {
    fit.Theta.resize(0, 0);
    return fit;
  }
  const VectorXd solution =
      qr.solve(VectorXd(Eigen::Map<const VectorXd>(r.target.data(), r.target.size())));
  for (Index i = 0; i < nx; ++i) refineRow(r, i, scaled_root, solution, fit);
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
