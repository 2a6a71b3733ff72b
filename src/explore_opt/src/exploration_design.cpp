#include "explore_opt/exploration_design.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "checks.hpp"
#include "constraint_shape.hpp"
#include "design_tools.hpp"
#include "doubtful_answer.hpp"
#include "explore_opt/audit.hpp"
#include "peak_limits.hpp"
#include "quad_support/linear_algebra.hpp"
#include "response_root.hpp"

namespace explore_opt {
namespace {

constexpr int kMostStarts = 10000;

void validate(const DesignOptions& options) {
  requirePositive(options.gap_tolerance, "gap tolerance");
  require(options.random_starts >= 0 && options.random_starts <= kMostStarts,
          "random starts = {}; must lie in 0..{}: after a few hundred others find nothing cheaper",
          options.random_starts, kMostStarts);
  requirePositive(options.cost_tolerance, "cost tolerance");
  requirePositive(options.step_tolerance, "step tolerance");
  requirePositive(options.inner_gap, "inner gap");
  require(options.inner_gap < 1.0, "inner gap = {}; must be below 1", options.inner_gap);
  require(options.max_iterations >= 1, "max iterations = {}; must be at least 1",
          options.max_iterations);
  requireFinite(options.initial_amplitudes, "initial amplitudes");
}

/// Combinations a method does not solve are the caller's mistake.
void validateFor(const ExplorationProblem& problem, const DesignOptions& options) {
  if (options.method == DesignMethod::kMm) {
    require(problem.u_max.size() == 0,
            "method mm knows no u_max: its relaxations need a start within the limit, which only "
            "method global finds; use method global");
  }
  require(problem.u_max.size() == 0 || problem.experiments == 1,
          "u_max with experiments = {} is not solved; leave one of them out", problem.experiments);
}

/// From rest ± a cost and achieve the same: the answer has its largest entry positive.
Eigen::VectorXd withPositiveLargest(const Eigen::VectorXd& a) {
  Eigen::Index largest = 0;
  a.cwiseAbs().maxCoeff(&largest);
  return a(largest) < 0.0 ? Eigen::VectorXd(-a) : a;
}

void refuse(DesignResult& result, const std::string& why) {
  result.status = DesignStatus::kNumericalError;
  result.message = why;
}

/// What is proven without amplitudes: the bound, and the multipliers that prove it.
void fillBound(const ExplorationProblem& problem, const RawDesign& raw, DesignResult& result) {
  result.lower_bound = raw.certificate.bound;
  if (raw.certificate.root.size() > 0) {
    result.certificate = raw.certificate.root * raw.certificate.root.transpose();
    result.multiplier_root = ConstraintShape(problem).multiplierRoot(raw.certificate.root);
    result.multiplier = result.multiplier_root * result.multiplier_root.transpose();
  }
  for (Eigen::Index k = 0; k < raw.certificate.nu.size(); ++k) {
    const PeakConstraint& peak = raw.peaks[static_cast<std::size_t>(k)];
    const double value = raw.certificate.nu(k) / (peak.limit * peak.limit);
    if (value > 0.0) result.peak_multipliers.push_back({peak.sample, peak.input, value});
  }
}

/// The amplitudes, unless they miss the condition or the limit.
void fillAmplitudes(const ExplorationProblem& problem, const DesignTask& single,
                    const RawDesign& raw, DesignResult& result) {
  const DesignTask task = single.replicated(problem.experiments);
  const double lambda_min = task.response.lambdaMin(raw.amplitudes) / task.gamma_w;
  if (!raw.amplitudes.allFinite() || !(lambda_min >= 1.0 - AuditTolerance::kInformation)) {
    return refuse(result, fmt::format("the amplitudes reach only {} of the required information",
                                      lambda_min));
  }
  const Eigen::MatrixXd amplitudes = task.table(
      task.response.homogeneous() ? withPositiveLargest(raw.amplitudes) : raw.amplitudes);
  if (problem.u_max.size() > 0) {
    result.peak = peakRatio(problem, amplitudes);
    if (!(result.peak <= 1.0 + 1e-9))
      return refuse(result, fmt::format("the amplitudes found reach {} of u_max", result.peak));
  }
  result.amplitudes = amplitudes;
  result.gamma_e = task.costAt(raw.amplitudes);
  result.gap = result.gamma_e > 0.0 ? (result.gamma_e - result.lower_bound) / result.gamma_e : 0.0;
  result.lambda_min = task.informationRatio(raw.amplitudes);
}

void fill(const ExplorationProblem& problem, const DesignTask& single, const RawDesign& raw,
          DesignResult& result) {
  result.status = raw.status;
  result.message = raw.message;
  result.iterations = raw.iterations;
  result.inner_gap = raw.inner_gap;
  result.relaxation_rank = raw.rank;
  fillBound(problem, raw, result);
  if (raw.amplitudes.size() > 0) fillAmplitudes(problem, single, raw, result);
}

void withdraw(DesignResult& result, const std::string& why) {
  result.amplitudes.resize(0, 0);
  result.gamma_e = result.gap = result.lambda_min = result.peak =
      std::numeric_limits<double>::quiet_NaN();
  refuse(result, why);
}

/// Judged once more, in long double, where doubles may not have had the digits.
void confirm(const ExplorationProblem& problem, const DesignOptions& options,
             DesignResult& result) {
  const std::optional<Doubt> doubt = doubtOf(problem, result);
  if (!doubt) return;
  const std::string complaint = auditAnswer(problem, options, *doubt, result);
  if (!complaint.empty()) withdraw(result, complaint);
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
  validateFor(problem, options);
  DesignResult result;
  result.method = options.method;
  try {
    const DesignTask task = taskOf(problem);
    fill(problem, task,
         options.method == DesignMethod::kGlobal ? designGlobal(problem, task, options)
                                                 : designByMajorisation(problem, task, options),
         result);
    confirm(problem, options, result);
  } catch (const ResponseOverflow& e) {
    refuse(result, e.what());
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

double lowerBound(const ExplorationProblem& problem, const Eigen::MatrixXd& certificate) {
  require(problem.u_max.size() == 0, "with u_max a bound needs the multipliers of the peaks too");
  const DesignTask task = taskOf(problem);
  requireShape(certificate, task.response.size(), task.response.size(), "certificate");
  requireFinite(certificate, "certificate");
  return task.certify(quad_support::positiveRoot(certificate)).bound;
}

double scaledCost(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes) {
  const DesignTask task = taskOf(problem);
  requireShape(amplitudes, numCarriers(problem.lines, problem.phase), problem.numInputs(),
               "amplitudes");
  requireFinite(amplitudes, "amplitudes");
  return task.cost(task.components(amplitudes));
}

}  // namespace explore_opt
