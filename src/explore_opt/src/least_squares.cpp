#include "explore_opt/least_squares.hpp"

#include <Eigen/QR>
#include <limits>

#include "checks.hpp"
#include "quad_support/linear_algebra.hpp"
#include "refinement.hpp"

namespace explore_opt {
namespace {

constexpr double kLargestCondition = 1e10;

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

}  // namespace

LeastSquaresFit fitLeastSquares(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U) {
  requireTrajectory(X, U);
  const Eigen::Index T = U.cols(), n = X.rows() + U.rows();
  require(T >= n,
          "{} samples for {} regressors (states and inputs); at least as many samples are needed",
          T, n);

  Eigen::MatrixXd regressor(T, n);  // Φᵀ
  regressor << X.leftCols(T).transpose(), U.transpose();
  const Eigen::VectorXd scales = exactScales(regressor);
  const Eigen::MatrixXd scaled = regressor * scales.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();

  LeastSquaresFit fit;
  fit.num_samples = static_cast<int>(T);
  fit.singular_values = quad_support::singularValues(unitColumns(R));
  fit.condition = conditionOf(fit.singular_values);
  fit.exciting = fit.condition <= kLargestCondition;
  fit.root = R * scales.asDiagonal();
  fit.information = regressor.transpose() * regressor;
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

}  // namespace explore_opt
