#include "grown_answer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "explore_opt/audit.hpp"
#include "global_search.hpp"
#include "response_root.hpp"

namespace explore_opt {
namespace {

constexpr double kShort = 1e-10;    // of the information: mended from here on
constexpr double kRestated = 1e-6;  // change of the gap worth a word

AuditReport audited(const ExplorationProblem& problem, const DesignResult& result,
                    const Eigen::MatrixXd& amplitudes) {
  DesignClaims claims;
  claims.amplitudes = amplitudes;
  claims.gamma_e = result.gamma_e;
  claims.lower_bound = result.lower_bound;
  claims.multiplier_root = result.multiplier_root;
  for (const PeakMultiplier& peak : result.peak_multipliers)
    claims.peak_multipliers.push_back({peak.sample, peak.input, peak.value});
  return audit(problem, claims);
}

/// Of an answer without amplitudes: the bound needs none. What is not proven is taken back.
bool boundStands(const ExplorationProblem& problem, DesignResult& result) {
  if (result.multiplier_root.size() == 0) return true;
  const Eigen::MatrixXd none =
      Eigen::MatrixXd::Zero(numCarriers(problem.lines, problem.phase), problem.numInputs());
  const double claimed = result.lower_bound;
  result.lower_bound = std::min(claimed, audited(problem, result, none).lower_bound);
  return claimed <= result.lower_bound * (1.0 + AuditTolerance::kBound);
}

/// Says in status and message what the audit has changed.
void restate(const DesignOptions& options, double claimed, double growth, DesignResult& result) {
  const bool certified = result.status == DesignStatus::kSolved &&
                         result.method == DesignMethod::kGlobal && claimed <= options.gap_tolerance;
  if (certified && result.gap <= options.gap_tolerance) {
    result.message = globallyOptimal(result.gap);
    return;
  }
  if (result.gap <= claimed + kRestated) return;
  if (certified) result.status = DesignStatus::kReducedAccuracy;
  result.message +=
      fmt::format("; with the rounding of modes that grow {:.0e}-fold, {:.2g}", growth, result.gap);
}

}  // namespace

std::string auditGrown(const ExplorationProblem& problem, const DesignOptions& options,
                       double growth, DesignResult& result) {
  const auto complaint = [&](const char* what) {
    return fmt::format(
        "the modes of {} grow {:.0e}-fold within T = {}, and {} not stand a simulation in more "
        "digits. {}",
        dynamicsName(problem), growth, problem.lines.num_samples, what, growthRemedy(problem));
  };
  if (!result.feasible())
    return boundStands(problem, result) ? "" : complaint("the bound found does");

  AuditReport report = audited(problem, result, result.amplitudes);
  if (report.lambda_min > 0.0 && report.lambda_min < 1.0 - kShort) {
    result.amplitudes *= std::sqrt(1.0 / report.lambda_min) * (1.0 + 1e-12);
    report = audited(problem, result, result.amplitudes);
  }
  const double claimed = result.gap;
  result.lower_bound = std::min(result.lower_bound, report.lower_bound);
  result.gamma_e = report.gamma_e;
  result.lambda_min = report.lambda_min;
  result.gap = report.gamma_e > 0.0 ? 1.0 - result.lower_bound / report.gamma_e : 0.0;
  if (problem.u_max.size() > 0) result.peak = report.peak_ratio;
  const bool stands = report.lambda_min >= 1.0 - AuditTolerance::kInformation &&
                      report.peak_ratio <= 1.0 + AuditTolerance::kPeak &&
                      result.gap >= -AuditTolerance::kGap;
  if (!stands) return complaint("the amplitudes found do");
  restate(options, claimed, growth, result);
  return "";
}

}  // namespace explore_opt
