#include "explore_opt/least_squares.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "checks.hpp"
#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"
#include "refinement.hpp"

namespace explore_opt {
namespace {

/// Columns scaled to length one; a column of zeros stays visible.
Eigen::MatrixXd unitColumns(const Eigen::MatrixXd& R) {
  Eigen::VectorXd lengths = R.colwise().norm();
  for (double& length : lengths) length = length > 0.0 ? length : 1.0;
  return R * lengths.cwiseInverse().asDiagonal();
}

double conditionOf(const Eigen::VectorXd& singular_values) {
  const double least = singular_values(singular_values.size() - 1);
  return least > 0.0 ? singular_values(0) / least : std::numeric_limits<double>::infinity();
}

/// Φᵀ, T x n_φ.
Eigen::MatrixXd regressorOf(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U) {
  Eigen::MatrixXd regressor(U.cols(), X.rows() + U.rows());
  regressor << X.leftCols(U.cols()).transpose(), U.transpose();
  return regressor;
}

/// All that can be said without the targets. @param R  triangle of the scaled regressor
LeastSquaresFit excitationOf(const Eigen::MatrixXd& regressor, const Eigen::VectorXd& scales,
                             const Eigen::MatrixXd& R) {
  LeastSquaresFit fit;
  fit.num_samples = static_cast<int>(regressor.rows());
  fit.singular_values = quad_support::singularValues(unitColumns(R));
  fit.condition = conditionOf(fit.singular_values);
  fit.exciting = fit.condition <= kLargestCondition;
  fit.root = R * scales.asDiagonal();
  fit.information = regressor.transpose() * regressor;
  return fit;
}

}  // namespace

LeastSquaresFit fitLeastSquares(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U) {
  requireTrajectory(X, U);
  const Eigen::Index T = U.cols(), n = X.rows() + U.rows();
  require(T >= n,
          "{} samples for {} regressors (states and inputs); at least as many samples are needed",
          T, n);

  const Eigen::MatrixXd regressor = regressorOf(X, U);
  const Eigen::VectorXd scales = exactScales(regressor);
  const Eigen::MatrixXd scaled = regressor * scales.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();

  LeastSquaresFit fit = excitationOf(regressor, scales, R);
  if (!fit.exciting) return fit;

  // Θ̂ᵀ = diag(scales)⁻¹ R⁻¹ Qᵀ Yᵀ; the normal equations would square the condition number.
  const Eigen::MatrixXd target = X.rightCols(T).transpose();
  const Eigen::MatrixXd projected = (qr.householderQ().transpose() * target).topRows(n);
  const Eigen::MatrixXd solution = R.triangularView<Eigen::Upper>().solve(projected);
  const RefinedSolution refined = refine(scaled, target, R, solution);
  fit.Theta = (scales.cwiseInverse().asDiagonal() * refined.solution).transpose();
  fit.residual = refined.residual.transpose();
  fit.residual_energy = fit.residual.squaredNorm();
  return fit;
}

LeastSquaresFit openFit(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U) {
  requireTrajectory(X, U);
  const Eigen::Index T = U.cols(), n = X.rows() + U.rows();
  const Eigen::MatrixXd regressor = regressorOf(X, U);
  const Eigen::VectorXd scales = exactScales(regressor);
  const Eigen::MatrixXd scaled = regressor * scales.cwiseInverse().asDiagonal();
  Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(std::max(T, n), n);
  padded.topRows(T) = scaled;
  const Eigen::MatrixXd R = Eigen::HouseholderQR<Eigen::MatrixXd>(padded)
                                .matrixQR()
                                .topRows(n)
                                .triangularView<Eigen::Upper>();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1.0 / kLargestCondition);
  decomposition.compute(scaled);

  LeastSquaresFit fit = excitationOf(regressor, scales, R);
  const Eigen::MatrixXd target = X.rightCols(T).transpose();
  const Eigen::MatrixXd solution = decomposition.solve(target);
  fit.Theta = (scales.cwiseInverse().asDiagonal() * solution).transpose();
  fit.residual = (target - scaled * solution).transpose();
  fit.residual_energy = fit.residual.squaredNorm();
  return fit;
}

}  // namespace explore_opt
