#include "explore_opt/classical_designs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

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

/// Regressors whose coefficients are unknown in some rows of Θ. The information on all unknown
/// entries is one block Q[J, J] for each row, so rows with the same J count together.
struct UnknownSet {
  std::vector<int> regressors;  ///< J
  double weight = 0.0;          ///< part of the rows that have unknown entries
};

std::vector<UnknownSet> unknownRows(const ExplorationProblem& problem) {
  std::vector<UnknownSet> sets;
  double rows = 0.0;
  for (int i = 0; i < problem.numStates(); ++i) {
    std::vector<int> unknown;
    for (int j = 0; j < problem.numRegressors(); ++j) {
      if (problem.known.size() == 0 || std::isnan(problem.known(i, j))) unknown.push_back(j);
    }
    if (unknown.empty()) continue;
    const auto same = std::find_if(
        sets.begin(), sets.end(), [&](const UnknownSet& set) { return set.regressors == unknown; });
    if (same != sets.end()) {
      same->weight += 1.0;
    } else {
      sets.push_back({unknown, 1.0});
    }
    rows += 1.0;
  }
  for (UnknownSet& set : sets) set.weight /= rows;
  return sets;
}

/// The inverse of N = FᵀF and log det N, from F = QR; the inverse is empty if N is singular.
struct Inverse {
  MatrixXd matrix;
  double log_determinant = 0.0;
};

Inverse inverseOf(const MatrixXd& F) {
  const auto n = F.cols();
  if (F.rows() < n) return {};
  const MatrixXd R = quad_support::triangularFactor(F);
  const VectorXd diagonal = R.diagonal().cwiseAbs();
  if (!(diagonal.minCoeff() > 0.0) || !diagonal.allFinite()) return {};
  const MatrixXd root =
      R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(n, n));  // N⁻¹ = R⁻¹ R⁻ᵀ
  return {root * root.transpose(), 2.0 * diagonal.array().log().sum()};
}

/// The criterion made independent of the size of a, with its gradient; N_J = F_JᵀF_J with weights
/// w_J, n = Σ w_J |J|, t = Σ w_J tr N_J⁻¹.
/// D: Σ w_J (-log det N_J) + n log‖a‖²   ∂_i = -2 Σ w_J tr(N_J⁻¹ F_Jᵀ F_iJ) + 2 n a_i/‖a‖²
/// A: log t + log‖a‖²                    ∂_i = -2 Σ w_J tr(N_J⁻² F_Jᵀ F_iJ)/t + 2 a_i/‖a‖²
Value evaluate(const PredictedResponse& response, const std::vector<UnknownSet>& sets,
               ClassicalCriterion criterion, const VectorXd& a) {
  const MatrixXd F = response.factor(a);
  const bool volume = criterion == ClassicalCriterion::kD;
  double degree = 0.0, logarithms = 0.0, trace = 0.0;
  MatrixXd weighted = MatrixXd::Zero(F.rows(), F.cols());
  for (const UnknownSet& set : sets) {
    const MatrixXd part = F(Eigen::all, set.regressors);
    const Inverse inverse = inverseOf(part);
    if (inverse.matrix.size() == 0) return {};
    degree += set.weight * static_cast<double>(part.cols());
    logarithms += set.weight * inverse.log_determinant;
    trace += set.weight * inverse.matrix.trace();
    weighted(Eigen::all, set.regressors) +=
        set.weight * part * (volume ? inverse.matrix : MatrixXd(inverse.matrix * inverse.matrix));
  }
  if (!volume) {
    degree = 1.0;
    weighted /= trace;
  }
  Value out;
  out.value = (volume ? -logarithms : std::log(trace)) + degree * std::log(a.squaredNorm());
  out.gradient = 2.0 * degree / a.squaredNorm() * a;
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

/// Directions in the coordinates b of the cost, γ_e = ‖b‖.
MatrixXd bestOfStarts(const ExplorationProblem& problem, ClassicalCriterion criterion,
                      std::uint64_t seed) {
  ExplorationProblem open = problem;  // whole regressors: rows of Θ count as often as they are
  open.known.resize(0, 0);
  const DesignTask task = taskOf(open);
  const std::vector<UnknownSet> sets = unknownRows(problem);
  const Objective f = [&](const VectorXd& b) {
    return evaluate(task.response, sets, criterion, b);
  };
  const auto simple = cheapestSimpleDirection(taskOf(problem), seed);
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
  plain.u_max.resize(0);
  plain.experiments = 1;
  if (criterion == ClassicalCriterion::kE) {
    DesignOptions options;
    options.seed = seed;
    const DesignResult design = designExploration(plain, options);
    return design.feasible() ? MatrixXd(design.amplitudes / design.gamma_e) : MatrixXd();
  }
  return bestOfStarts(plain, criterion, seed);
}

}  // namespace explore_opt
