#include "explore_opt/parameter_functions.hpp"

#include "checks.hpp"
#include "constants.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

/// R^{-T} Cᵀ: its squared norm is c^T P c.
MatrixXd spread(const FeasibleSet& set, const AffineFunction& f) {
  return set.root.triangularView<Eigen::Upper>().transpose().solve(f.weights.transpose());
}

Interval quotient(const FeasibleSet& set, const ParameterFunction& f) {
  const MatrixXd n_spread = spread(set, f.numerator), d_spread = spread(set, *f.denominator);
  const double n = f.numerator.at(set.center), d = f.denominator->at(set.center);
  const double qnn = set.G * n_spread.squaredNorm(), qdd = set.G * d_spread.squaredNorm(),
               qnd = set.G * n_spread.cwiseProduct(d_spread).sum();
  const double leading = d * d - qdd;  // ρ² leading - 2ρ middle + (n² - qnn) <= 0
  if (!(leading > 0.0)) return {n / d, -kInfinity, kInfinity};
  const double middle = n * d - qnd;
  const double root = std::sqrt(std::max(0.0, middle * middle - leading * (n * n - qnn)));
  return {n / d, (middle - root) / leading, (middle + root) / leading};
}

}  // namespace

double AffineFunction::at(const Eigen::MatrixXd& Theta) const {
  return constant + weights.cwiseProduct(Theta).sum();
}

std::optional<Interval> intervalOf(const FeasibleSet& set, const ParameterFunction& function) {
  requireShape(function.numerator.weights, set.center.rows(), set.center.cols(), "weights");
  if (set.falsified()) return std::nullopt;
  if (function.denominator) return quotient(set, function);
  const double value = function.numerator.at(set.center);
  const double half = std::sqrt(set.G) * spread(set, function.numerator).norm();
  return Interval{value, value - half, value + half};
}

}  // namespace explore_opt
