#include "explore_opt/exploration_design.hpp"

#include <chrono>
#include <cmath>

#include "checks.hpp"
#include "design_tools.hpp"

namespace explore_opt {
namespace {

DesignTask taskOf(const ExplorationProblem& problem) {
  return {predictResponse(problem), problem.gamma_w, problem.numInputs()};
}

void validate(const DesignOptions& options) {
  requirePositive(options.gap_tolerance, "gap tolerance");
  require(options.random_starts >= 0, "random starts = {}; must be 0 or above",
          options.random_starts);
  requirePositive(options.cost_tolerance, "cost tolerance");
  requirePositive(options.step_tolerance, "step tolerance");
  requirePositive(options.inner_gap, "inner gap");
  require(options.inner_gap < 1.0, "inner gap = {}; must be below 1", options.inner_gap);
  require(options.max_iterations >= 1, "max iterations = {}; must be at least 1",
          options.max_iterations);
  requireFinite(options.initial_amplitudes, "initial amplitudes");
}

/// ± a cost and achieve the same: the answer has its largest entry positive.
Eigen::VectorXd withPositiveLargest(const Eigen::VectorXd& a) {
  Eigen::Index largest = 0;
  a.cwiseAbs().maxCoeff(&largest);
  return a(largest) < 0.0 ? Eigen::VectorXd(-a) : a;
}

void fill(const DesignTask& task, const RawDesign& raw, DesignResult& result) {
  result.status = raw.status;
  result.message = raw.message;
  result.iterations = raw.iterations;
  result.inner_gap = raw.inner_gap;
  result.certificate = raw.certificate.Z;
  result.lower_bound = raw.certificate.bound;
  if (raw.amplitudes.size() == 0) return;
  const double lambda_min = task.response.lambdaMin(raw.amplitudes) / task.gamma_w;
  if (!raw.amplitudes.allFinite() || !(lambda_min >= 1.0 - 1e-9)) {
    result.status = DesignStatus::kNumericalError;
    result.message =
        fmt::format("the amplitudes reach only {} of the required information", lambda_min);
    return;
  }
  result.amplitudes = task.table(withPositiveLargest(raw.amplitudes));
  result.gamma_e = raw.amplitudes.norm();
  result.gap = (result.gamma_e - result.lower_bound) / result.gamma_e;
  result.lambda_min = lambda_min;
}

}  // namespace

std::string toString(DesignMethod method) {
  return method == DesignMethod::kGlobal ? "global" : "mm";
}

DesignMethod methodFromString(const std::string& text) {
  for (const DesignMethod method : {DesignMethod::kGlobal, DesignMethod::kMm}) {
    if (text == toString(method)) return method;
  }
  throw quad_support::DataError(fmt::format("method = '{}'; must be global or mm", text));
}

std::string toString(DesignStatus status) {
  switch (status) {
    case DesignStatus::kSolved:
      return "solved";
    case DesignStatus::kReducedAccuracy:
      return "reduced_accuracy";
    case DesignStatus::kInfeasible:
      return "infeasible";
    case DesignStatus::kNotExciting:
      return "not_exciting";
    case DesignStatus::kIterationLimit:
      return "iteration_limit";
    case DesignStatus::kNumericalError:
      return "numerical_error";
  }
  return "numerical_error";
}

DesignResult designExploration(const ExplorationProblem& problem, const DesignOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  validate(options);
  const DesignTask task = taskOf(problem);
  DesignResult result;
  result.method = options.method;
  fill(task,
       options.method == DesignMethod::kGlobal ? designGlobal(task, options)
                                               : designByMajorisation(task, options),
       result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

double lowerBound(const ExplorationProblem& problem, const Eigen::MatrixXd& certificate) {
  const DesignTask task = taskOf(problem);
  requireShape(certificate, task.response.size(), task.response.size(), "certificate");
  requireFinite(certificate, "certificate");
  return task.certify(certificate).bound;
}

double scaledCost(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes) {
  const DesignTask task = taskOf(problem);
  requireShape(amplitudes, numCarriers(problem.lines, problem.phase), problem.numInputs(),
               "amplitudes");
  requireFinite(amplitudes, "amplitudes");
  return task.cost(task.components(amplitudes));
}

}  // namespace explore_opt
