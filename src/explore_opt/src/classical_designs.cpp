#include "explore_opt/classical_designs.hpp"

#include <functional>
#include <limits>

#include "checks.hpp"
#include "constants.hpp"
#include "design_tools.hpp"
#include "explore_opt/exploration_design.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kStarts = 8;

struct Value {
  double value = kInfinity;
  VectorXd gradient;
};

/// The criterion made independent of the size of a, with its gradient; N = FᵀF, F = QR.
/// D: -log det N + n log‖a‖²        ∂_i = -2 tr(N⁻¹ FᵀF_i) + 2 n a_i/‖a‖²
/// A: log tr N⁻¹ + log‖a‖²          ∂_i = -2 tr(N⁻² FᵀF_i)/tr N⁻¹ + 2 a_i/‖a‖²
Value evaluate(const PredictedResponse& response, ClassicalCriterion criterion, const VectorXd& a) {
  const MatrixXd F = response.factor(a);
  const auto n = F.cols();
  const MatrixXd R = quad_support::triangularFactor(F);
  const VectorXd diagonal = R.diagonal().cwiseAbs();
  if (!(diagonal.minCoeff() > 0.0) || !diagonal.allFinite()) return {};
  const MatrixXd inverse_root =
      R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(n, n));  // N⁻¹ = R⁻¹ R⁻ᵀ
  const MatrixXd inverse = inverse_root * inverse_root.transpose();
  const bool volume = criterion == ClassicalCriterion::kD;
  const double square = a.squaredNorm(), trace = inverse.trace();
  const double degree = volume ? static_cast<double>(n) : 1.0;
  const MatrixXd weighted = F * (volume ? inverse : MatrixXd(inverse * inverse / trace));
  Value out;
  out.value =
      (volume ? -2.0 * diagonal.array().log().sum() : std::log(trace)) + degree * std::log(square);
  out.gradient = 2.0 * degree / square * a;
  for (int i = 0; i < a.size(); ++i) {
    out.gradient(i) -=
        2.0 * weighted.cwiseProduct(response.factors[static_cast<std::size_t>(i)]).sum();
  }
  if (!std::isfinite(out.value) || !out.gradient.allFinite()) return {};
  return out;
}

using Objective = std::function<Value(const VectorXd&)>;

/// Quasi-Newton descent with halved steps; ends when a step gains nothing any more.
VectorXd descend(const Objective& f, VectorXd a) {
  const auto p = a.size();
  Value here = f(a);
  MatrixXd inverse_hessian = 0.1 * MatrixXd::Identity(p, p);
  for (int iteration = 0; iteration < 500 && here.gradient.norm() > 1e-8; ++iteration) {
    VectorXd step = -inverse_hessian * here.gradient;
    if (step.dot(here.gradient) >= 0.0) step = -0.1 * here.gradient;
    Value next;
    double t = 1.0;
    for (; t > 1e-12; t *= 0.5) {
      next = f(a + t * step);
      if (next.value <= here.value + 1e-4 * t * step.dot(here.gradient)) break;
    }
    if (t <= 1e-12) break;
    const VectorXd s = t * step, y = next.gradient - here.gradient;
    const double curvature = s.dot(y);
    if (curvature > 1e-14 * s.norm() * y.norm()) {  // keeps it positive definite
      const MatrixXd left = MatrixXd::Identity(p, p) - s * y.transpose() / curvature;
      inverse_hessian = left * inverse_hessian * left.transpose() + s * s.transpose() / curvature;
    }
    a += s;
    here = next;
  }
  return a / a.norm();
}

MatrixXd bestOfStarts(const DesignTask& task, ClassicalCriterion criterion, std::uint64_t seed) {
  const Objective f = [&](const VectorXd& a) { return evaluate(task.response, criterion, a); };
  const auto simple = cheapestSimpleDirection(task, seed);
  if (!simple) return {};
  VectorXd best;
  double least = kInfinity;
  for (int i = 0; i <= kStarts; ++i) {
    VectorXd start =
        i == 0 ? VectorXd(simple->normalized())
               : VectorXd(randomDirection(task, seed, static_cast<std::uint64_t>(i)).normalized());
    if (!std::isfinite(f(start).value)) continue;
    const VectorXd end = descend(f, start);
    const double value = f(end).value;
    if (value >= least) continue;
    least = value;
    best = end;
  }
  return best.size() > 0 ? task.table(best) : MatrixXd();
}

}  // namespace

std::string toString(ClassicalCriterion criterion) {
  return criterion == ClassicalCriterion::kD   ? "D-optimal"
         : criterion == ClassicalCriterion::kA ? "A-optimal"
                                               : "E-optimal";
}

std::vector<ClassicalCriterion> allCriteria() {
  return {ClassicalCriterion::kD, ClassicalCriterion::kA, ClassicalCriterion::kE};
}

Eigen::MatrixXd classicalDesign(const ExplorationProblem& problem, ClassicalCriterion criterion,
                                std::uint64_t seed) {
  ExplorationProblem plain = problem;  // information in the parameters' own units
  plain.D_des = MatrixXd::Constant(1, 1, 1.0);
  plain.x0.resize(0);  // information grows with the square of the amplitudes
  plain.cost = CostOn::kSignal;
  plain.u_max.resize(0);
  plain.experiments = 1;
  if (criterion == ClassicalCriterion::kE) {
    DesignOptions options;
    options.seed = seed;
    const MatrixXd amplitudes = designExploration(plain, options).amplitudes;
    return amplitudes.size() > 0 ? MatrixXd(amplitudes / amplitudes.norm()) : MatrixXd();
  }
  DesignTask task;
  task.response = predictResponse(plain);
  task.gamma_w = plain.gamma_w;
  task.num_inputs = plain.numInputs();
  return bestOfStarts(task, criterion, seed);
}

}  // namespace explore_opt
