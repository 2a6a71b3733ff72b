#include "explore_opt/set_membership.hpp"

#include <unsupported/Eigen/KroneckerProduct>

#include "checks.hpp"
#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

Eigen::MatrixXd identity(Eigen::Index n) { return Eigen::MatrixXd::Identity(n, n); }

double smallestEigenvalue(const Eigen::MatrixXd& m) {
  return quad_support::symmetricEigenvalues(m)(0);
}

/// Largest eigenvalue of R⁻ᵀ D R⁻¹, the largest ratio of D to S = RᵀR in any direction.
double largestRatio(const Eigen::MatrixXd& closeness, const Eigen::MatrixXd& root) {
  const auto upper = root.triangularView<Eigen::Upper>();
  const Eigen::MatrixXd half = upper.transpose().solve(closeness);          // R⁻ᵀ D
  const Eigen::MatrixXd ratio = upper.transpose().solve(half.transpose());  // R⁻ᵀ Dᵀ R⁻¹
  const Eigen::MatrixXd symmetric = 0.5 * (ratio + ratio.transpose());
  return -smallestEigenvalue(-symmetric);
}

}  // namespace

std::optional<double> FeasibleSet::lambdaBound() const {
  if (G <= 0.0) return std::nullopt;
  return lambda_min_S / G;
}

FeasibleSet feasibleSet(const LeastSquaresFit& fit, double gamma_w) {
  requirePositive(gamma_w, "gamma_w");
  require(fit.exciting,
          "the data do not determine the parameters (condition {:.3g}); there is no bounded set",
          fit.condition);
  FeasibleSet set;
  set.center = fit.Theta;
  set.root = fit.root;
  set.gamma_w = gamma_w;
  // Eq. (1.8): G = γ_w + |θ̂|²_{P⁻¹} - Σ|x_{k+1}|². For the least-squares estimate this is γ_w -
  // |residual|²; the printed form subtracts numbers of the size of Σ|x|² and loses all digits of a
  // falling vehicle.
  set.G = gamma_w - fit.residual_energy;
  const double sigma = quad_support::singularValues(fit.root).tail(1)(0);
  set.lambda_min_S = sigma * sigma;
  return set;
}

double distance(const FeasibleSet& set, const Eigen::MatrixXd& Theta) {
  requireShape(Theta, set.center.rows(), set.center.cols(), "Theta");
  return ((Theta - set.center) * set.root.transpose()).squaredNorm();  // tr(Δ RᵀR Δᵀ)
}

bool contains(const FeasibleSet& set, const Eigen::MatrixXd& Theta) {
  return !set.falsified() && distance(set, Theta) <= set.G + 1e-10 * set.gamma_w;
}

void requireCloseness(const Eigen::MatrixXd& D, const char* name) {
  const Eigen::Index n = D.rows();
  require(n >= 1 && D.cols() == n, "{} is {} x {}; must be square", name, n, D.cols());
  requireFinite(D, name);
  const double size = D.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      require(std::abs(D(i, j) - D(j, i)) <= 1e-12 * size,
              "{4} is not symmetric: entry ({0}, {1}) is {2}, entry ({1}, {0}) is {3}", i, j,
              D(i, j), D(j, i), name);
    }
  }
  const double least = smallestEigenvalue(D);
  require(least >= -1e-12 * size, "{} has the eigenvalue {}; all must be 0 or above", name, least);
}

Eigen::MatrixXd fullCloseness(const Eigen::MatrixXd& closeness, int num_states,
                              int num_regressors) {
  const Eigen::Index n = num_states * num_regressors;
  requireCloseness(closeness);
  if (closeness.size() == 1) return closeness(0, 0) * identity(n);
  if (closeness.rows() == num_regressors)
    return Eigen::kroneckerProduct(closeness, identity(num_states)).eval();
  require(closeness.rows() == n,
          "D is {0} x {0}; must be a number, {1} x {1} (meaning D ⊗ I) or {2} x {2}",
          closeness.rows(), num_regressors, n);
  return closeness;
}

double informationMargin(const FeasibleSet& set, const Eigen::MatrixXd& closeness) {
  const auto nx = static_cast<int>(set.center.rows()), n = static_cast<int>(set.center.cols());
  if (closeness.size() == 1) {
    requireCloseness(closeness);
    const double lambda = closeness(0, 0);
    return lambda > 0.0 ? set.lambda_min_S / lambda : kInfinity;
  }
  if (closeness.rows() == n) return largestRadius(set.root, closeness);
  return largestRadius(Eigen::kroneckerProduct(set.root, identity(nx)).eval(),
                       fullCloseness(closeness, nx, n));
}

double largestRadius(const Eigen::MatrixXd& root, const Eigen::MatrixXd& closeness) {
  requireShape(closeness, root.cols(), root.cols(), "D");
  requireCloseness(closeness);
  const double ratio = largestRatio(closeness, root);
  return ratio > 0.0 ? 1.0 / ratio : kInfinity;
}

bool explorationCondition(const FeasibleSet& set, const Eigen::MatrixXd& closeness) {
  return !set.falsified() && informationMargin(set, closeness) >= set.G;
}

double explorationObjective(const Eigen::MatrixXd& theta_true,
                            const Eigen::MatrixXd& theta_estimate,
                            const Eigen::MatrixXd& closeness) {
  requireShape(theta_estimate, theta_true.rows(), theta_true.cols(), "estimated Theta");
  const Eigen::MatrixXd D = fullCloseness(closeness, static_cast<int>(theta_true.rows()),
                                          static_cast<int>(theta_true.cols()));
  const Eigen::MatrixXd difference = theta_true - theta_estimate;
  const Eigen::Map<const Eigen::VectorXd> e(difference.data(), difference.size());
  return e.dot(D * e);
}

double closenessOfFit(const Eigen::MatrixXd& theta_true, const Eigen::MatrixXd& theta_estimate) {
  requireShape(theta_estimate, theta_true.rows(), theta_true.cols(), "estimated Theta");
  return 1.0 / (theta_true - theta_estimate).squaredNorm();
}

ClosenessChain judgeChain(const FeasibleSet& set, const Eigen::MatrixXd& theta_true,
                          const Eigen::MatrixXd& desired, const Eigen::MatrixXd& initial) {
  const auto nx = static_cast<int>(set.center.rows()), n = static_cast<int>(set.center.cols());
  const Eigen::MatrixXd D = fullCloseness(desired, nx, n), D0 = fullCloseness(initial, nx, n);
  ClosenessChain chain;
  chain.truth_within_bound =
      contains(set, theta_true);  // e eᵀ ⪯ M and eᵀ M⁻¹ e <= 1 say the same for M ≻ 0
  chain.bound_within_desired = explorationCondition(set, desired);
  chain.desired_within_initial = smallestEigenvalue(D - D0) >= -1e-12 * D.cwiseAbs().maxCoeff();
  return chain;
}

}  // namespace explore_opt
