#include "explore_opt/signal_response.hpp"

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "constants.hpp"
#include "constraint_shape.hpp"
#include "explore_opt/set_membership.hpp"
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

/// Triangle R with RᵀR = M Mᵀ, square also for fewer samples than rows.
MatrixXd rootOf(const MatrixXd& wide) {
  MatrixXd tall = MatrixXd::Zero(std::max(wide.cols(), wide.rows()), wide.rows());
  tall.topRows(wide.cols()) = wide.transpose();
  return quad_support::triangularFactor(tall);
}

/// Largest G with Eᵀ(RᵀR ⊗ I)E ⪰ G EᵀD_desE, E the unknown entries, in the shape a design imposes;
/// 0 if R leaves one of them undetermined. What is known need not be excited.
double marginOf(const ConstraintShape& shape, const MatrixXd& root) {
  const MatrixXd F = shape.factor(root);
  const VectorXd lengths = F.colwise().norm();
  if (!(lengths.minCoeff() > 0.0) || !lengths.allFinite()) return 0.0;
  const VectorXd sigma = quad_support::singularValues(F * lengths.cwiseInverse().asDiagonal());
  if (!(sigma(0) <= kLargestCondition * sigma(sigma.size() - 1))) return 0.0;
  return largestRadius(quad_support::triangularFactor(F),
                       MatrixXd::Identity(shape.size(), shape.size()));
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
  const ConstraintShape shape(problem);
  const auto meets = [&](double s) { return marginOf(shape, affine.root(s)) >= problem.gamma_w; };
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

bool startsAtRest(const ExplorationProblem& problem) {
  return problem.x0.size() == 0 || problem.x0.isZero(0.0);
}

void requireSignals(const ExplorationProblem& problem, const MatrixXd& signal) {
  validate(problem);
  requireShape(signal, problem.numInputs(), Index{problem.lines.num_samples} * problem.experiments,
               "signal");
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
  requireSignals(problem, signal);
  if (!startsAtRest(problem)) return scaleFromAbove(problem, affineRegressor(problem, signal));
  const double margin = marginOf(ConstraintShape(problem), rootOf(regressor(problem, signal)));
  return margin > 0.0 ? std::sqrt(problem.gamma_w / margin) : kInfinity;  // degree 2
}

double cheapestScale(const ExplorationProblem& problem, const Eigen::MatrixXd& signal) {
  const double required = requiredScale(problem, signal);
  if (problem.cost == CostOn::kSignal || startsAtRest(problem) || !std::isfinite(required))
    return required;
  // Σ‖u⁰_k + s u¹_k‖², the answers to x0 and to the signal, is least at -Σ u⁰_k·u¹_k / Σ‖u¹_k‖².
  const AffineRegressor affine = affineRegressor(problem, signal);
  const Index nu = problem.numInputs();
  const MatrixXd free = affine.free.rightCols(nu), forced = affine.forced.rightCols(nu);
  const double square = forced.squaredNorm();
  return square > 0.0 ? std::max(required, -free.cwiseProduct(forced).sum() / square) : required;
}

double inputAmplitude(const ExplorationProblem& problem, const Eigen::MatrixXd& signal) {
  requireSignals(problem, signal);
  const Index T = problem.lines.num_samples;
  double sum = 0.0;
  for (Index first = 0; first < signal.cols(); first += T)
    sum += simulateNominal(problem, signal.middleCols(first, T)).U.squaredNorm();
  return std::sqrt(2.0 * sum / static_cast<double>(signal.cols()));
}

double equivalentAmplitude(const Eigen::MatrixXd& signal) {
  return std::sqrt(2.0 * signalEnergy(signal) / static_cast<double>(signal.cols()));
}

}  // namespace explore_opt
