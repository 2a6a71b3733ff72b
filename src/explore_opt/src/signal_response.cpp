#include "explore_opt/signal_response.hpp"

#include <cmath>

#include "checks.hpp"
#include "constants.hpp"
#include "explore_opt/set_membership.hpp"
#include "explore_opt/structured_least_squares.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Regressors of all experiments over √r: products of rows are their mean information.
MatrixXd regressor(const ExplorationProblem& problem, const MatrixXd& signal) {
  const Index T = problem.lines.num_samples;
  MatrixXd phi(problem.numRegressors(), signal.cols());
  for (Index first = 0; first < signal.cols(); first += T) {
    const NominalExperiment run = simulateNominal(problem, signal.middleCols(first, T));
    phi.middleCols(first, T) << run.X.leftCols(T), run.U;
  }
  return phi / std::sqrt(static_cast<double>(problem.experiments));
}

/// Triangle R with RᵀR = M Mᵀ of a wide matrix.
MatrixXd rootOf(const MatrixXd& wide) {
  if (wide.cols() < wide.rows()) return MatrixXd::Zero(wide.rows(), wide.rows());
  return quad_support::triangularFactor(wide.transpose());
}

/// The same on the unknown entries alone: Eᵀ(RᵀR ⊗ I)E ⪰ G Eᵀ D_des E.
double structuredMargin(const ExplorationProblem& problem, const MatrixXd& root) {
  const Index nx = problem.numStates();
  StructuredFit shape;
  shape.Theta = problem.known;
  for (int j = 0; j < problem.numRegressors(); ++j) {
    for (int i = 0; i < nx; ++i)
      if (std::isnan(problem.known(i, j))) shape.free.push_back({i, j});
  }
  const auto n = static_cast<Index>(shape.free.size());
  MatrixXd wide = MatrixXd::Zero(n, root.rows() * nx);  // rows: columns of (R ⊗ I) E
  for (Index e = 0; e < n; ++e) {
    const Entry at = shape.free[static_cast<std::size_t>(e)];
    for (Index r = 0; r < root.rows(); ++r) wide(e, r * nx + at.row) = root(r, at.column);
  }
  return largestRadius(rootOf(wide), restrictCloseness(problem.D_des, shape));
}

/// Largest G with RᵀR ⊗ I ⪰ G D_des; 0 if R is singular.
double marginOf(const ExplorationProblem& problem, const MatrixXd& root) {
  const VectorXd lengths = root.colwise().norm();
  if (!(lengths.minCoeff() > 0.0) || !lengths.allFinite()) return 0.0;
  const VectorXd sigma = quad_support::singularValues(root * lengths.cwiseInverse().asDiagonal());
  if (!(sigma(0) <= kLargestCondition * sigma(sigma.size() - 1))) return 0.0;
  if (problem.known.size() > 0) return structuredMargin(problem, root);
  FeasibleSet set;
  set.center = MatrixXd::Zero(problem.numStates(), problem.numRegressors());
  set.root = root;
  const double least = quad_support::singularValues(root).tail(1)(0);
  set.lambda_min_S = least * least;
  return informationMargin(set, problem.D_des);
}

/// Triangle of a QR of [Φ_0; Φ_1]ᵀ, whose sums stand for those of the T-long regressors.
struct AffineRegressor {
  MatrixXd free, forced;  ///< answer to x0 alone, and to the signal alone
  MatrixXd root(double scale) const { return rootOf((free + scale * forced).transpose()); }
};

AffineRegressor affineRegressor(const ExplorationProblem& problem, const MatrixXd& signal) {
  const Index n = problem.numRegressors();
  ExplorationProblem from_rest = problem;
  from_rest.x0 = VectorXd();
  MatrixXd both(2 * n, signal.cols());
  both << regressor(problem, MatrixXd::Zero(signal.rows(), signal.cols())),
      regressor(from_rest, signal);
  if (signal.cols() <= 2 * n) return {both.topRows(n).transpose(), both.bottomRows(n).transpose()};
  const MatrixXd R = rootOf(both);
  return {R.leftCols(n), R.rightCols(n)};
}

/// Bisection between a factor that meets the condition and one that does not.
double scaleFromAbove(const ExplorationProblem& problem, const AffineRegressor& affine) {
  const auto meets = [&](double s) { return marginOf(problem, affine.root(s)) >= problem.gamma_w; };
  double high = 1.0;
  while (!meets(high)) {
    high *= 2.0;
    if (high > 1e150) return kInfinity;
  }
  double low = high;
  while (meets(low)) {
    high = low;
    low /= 2.0;
    if (low < 1e-150) return 0.0;  // x0 alone excites enough
  }
  while (high - low > 1e-12 * high) {
    const double middle = 0.5 * (low + high);
    (meets(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

NominalExperiment simulateNominal(const ExplorationProblem& problem,
                                  const Eigen::MatrixXd& signal) {
  const int nx = problem.numStates(), nu = problem.numInputs();
  requireShape(signal, nu, problem.lines.num_samples, "signal");
  requireFinite(signal, "signal");
  NominalExperiment run{MatrixXd(nx, signal.cols() + 1), signal};
  run.X.col(0) = problem.x0.size() > 0 ? problem.x0 : VectorXd(VectorXd::Zero(nx));
  for (Index k = 0; k < signal.cols(); ++k) {
    if (problem.K.size() > 0) run.U.col(k) += problem.K * run.X.col(k);
    run.X.col(k + 1) = problem.A * run.X.col(k) + problem.B * run.U.col(k);
    require(run.X.col(k + 1).allFinite(),
            "the predicted states overflow at sample {} of {}: A grows too fast. Stabilise with K "
            "or shorten T",
            k + 1, signal.cols());
  }
  return run;
}

double requiredScale(const ExplorationProblem& problem, const Eigen::MatrixXd& signal) {
  validate(problem);
  requireShape(signal, problem.numInputs(), Index{problem.lines.num_samples} * problem.experiments,
               "signal");
  if (problem.x0.size() > 0 && !problem.x0.isZero(0.0))
    return scaleFromAbove(problem, affineRegressor(problem, signal));
  const double margin = marginOf(problem, rootOf(regressor(problem, signal)));
  return margin > 0.0 ? std::sqrt(problem.gamma_w / margin) : kInfinity;  // degree 2
}

double equivalentAmplitude(const Eigen::MatrixXd& signal) {
  return std::sqrt(2.0 * signalEnergy(signal) / static_cast<double>(signal.cols()));
}

}  // namespace explore_opt
