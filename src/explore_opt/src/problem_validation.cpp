#include <cmath>

#include "checks.hpp"
#include "constants.hpp"
#include "explore_opt/exploration_problem.hpp"
#include "explore_opt/set_membership.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

constexpr double kMaxTable = 5e7;  // numbers in the table of products S_ab: 400 MB
constexpr int kMaxSamples = 10'000'000;

void checkSystem(const ExplorationProblem& problem) {
  const Index nx = problem.A.rows(), nu = problem.B.cols();
  require(nx >= 1, "A is empty");
  require(nu >= 1, "B has no column; there must be at least one input");
  requireShape(problem.A, nx, nx, "A");
  requireShape(problem.B, nx, nu, "B");
  requireFinite(problem.A, "A");
  requireFinite(problem.B, "B");
  if (problem.K.size() > 0) {
    requireShape(problem.K, nu, nx, "K");
    requireFinite(problem.K, "K");
  }
  if (problem.x0.size() > 0) {
    requireShape(problem.x0, nx, 1, "x0");
    requireFinite(problem.x0, "x0");
  }
}

void checkKnown(const ExplorationProblem& problem) {
  if (problem.known.size() == 0) return;
  requireShape(problem.known, problem.numStates(), problem.numRegressors(), "known");
  bool any = false;
  for (int i = 0; i < problem.numStates(); ++i) {
    for (int j = 0; j < problem.numRegressors(); ++j) {
      const double value = problem.known(i, j);
      if (std::isnan(value)) {
        any = true;
        continue;
      }
      const double nominal =
          j < problem.numStates() ? problem.A(i, j) : problem.B(i, j - problem.numStates());
      require(value == nominal,
              "known: row {}, column {} is {}, but [A B] has {} there; a known entry must be the "
              "nominal one",
              i + 1, j + 1, value, nominal);
    }
  }
  require(any, "known leaves nothing to learn; at least one entry must be null");
}

void checkCloseness(const ExplorationProblem& problem) {
  requireShape(problem.D_des, problem.D_des.rows(), problem.D_des.rows(), "D_des");
  const int n = problem.numRegressors();
  const Index rows = problem.D_des.rows();
  require(rows == 1 || rows == n || rows == Index{n} * problem.numStates(),
          "D_des is {0} x {0}; must be a number, {1} x {1} (n_phi = n_x + n_u, meaning D (x) I) or "
          "{2} x {2} (n_phi n_x)",
          rows, n, Index{n} * problem.numStates());
  requireCloseness(problem.D_des, "D_des");
  require(problem.D_des.trace() > 0.0, "D_des is zero; it must ask for something");
}

void checkInputLimit(const ExplorationProblem& problem) {
  if (problem.u_max.size() == 0) return;
  const Index nu = problem.numInputs();
  require(problem.u_max.size() == 1 || problem.u_max.size() == nu,
          "u_max has {} entries; must be one number, or one for each of the {} inputs",
          problem.u_max.size(), nu);
  for (Index j = 0; j < problem.u_max.size(); ++j) requirePositive(problem.u_max(j), "u_max");
}

void checkSize(const ExplorationProblem& problem) {
  const double p = problem.numAmplitudes();
  double n = problem.numRegressors();
  if (problem.D_des.rows() > problem.numRegressors()) n *= problem.numStates();
  require(problem.lines.num_samples <= kMaxSamples, "T = {}; must be at most {}",
          problem.lines.num_samples, kMaxSamples);
  require(0.5 * p * p * n * n <= kMaxTable,
          "the problem is too large: {:g} amplitudes and a condition of size {:g} need a table of "
          "{:.2g} GB; fewer lines, one phase, or D_des of size n_phi make it smaller",
          p, n, 4e-9 * p * p * n * n);
  require(problem.experiments >= 1 && problem.experiments <= 64,
          "experiments = {}; must lie in 1..64", problem.experiments);
}

}  // namespace

std::string toString(CostOn cost) { return cost == CostOn::kSignal ? "signal" : "input"; }

CostOn costFromString(const std::string& text) {
  for (const CostOn cost : {CostOn::kSignal, CostOn::kInput}) {
    if (text == toString(cost)) return cost;
  }
  throw quad_support::DataError(fmt::format("cost = '{}'; must be signal or input", text));
}

void validate(const ExplorationProblem& problem) {
  checkSystem(problem);
  validate(problem.lines);
  requirePositive(problem.gamma_w, "gamma_w");
  checkSize(problem);
  checkKnown(problem);
  checkCloseness(problem);
  checkInputLimit(problem);
}

}  // namespace explore_opt
