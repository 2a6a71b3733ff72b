#include "doubtful_answer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "explore_opt/audit.hpp"
#include "global_search.hpp"
#include "response_root.hpp"

namespace explore_opt {
namespace {

constexpr double kDoubtful = 1e5;   // growth, or cancellation
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
void restate(const DesignOptions& options, double claimed, const Doubt& doubt,
             DesignResult& result) {
  const bool certified = result.status == DesignStatus::kSolved &&
                         result.method == DesignMethod::kGlobal && claimed <= options.gap_tolerance;
  if (certified && result.gap <= options.gap_tolerance) {
    result.message = globallyOptimal(result.gap);
    return;
  }
  if (result.gap <= claimed + kRestated) return;
  if (certified) result.status = DesignStatus::kReducedAccuracy;
  result.message +=
      fmt::format("; {}, and with that rounding the gap is {:.2g}", doubt.cause, result.gap);
}

}  // namespace

std::optional<Doubt> doubtOf(const ExplorationProblem& problem, const DesignResult& result) {
  const int T = problem.lines.num_samples;
  const double growth = modeGrowth(problem);
  if (growth > kDoubtful) {
    return Doubt{fmt::format("the modes of {} grow {:.0e}-fold within T = {}",
                             dynamicsName(problem), growth, T),
                 growthRemedy(problem)};
  }
  if (!result.feasible()) return std::nullopt;
  const double cancelling = cancellation(problem, result.amplitudes);
  if (cancelling > kDoubtful) {
    return Doubt{fmt::format("the responses to single lines are {:.0e} times what their sum leaves "
                             "within T = {}",
                             cancelling, T),
                 problem.K.size() > 0 ? "Shorten T" : "Shorten T, or hold the states with K"};
  }
  if (result.gap < -AuditTolerance::kGap) {
    return Doubt{fmt::format("the cost {:.9g} lies below the bound {:.9g}", result.gamma_e,
                             result.lower_bound),
                 "Shorten T"};
  }
  return std::nullopt;
}

std::string auditAnswer(const ExplorationProblem& problem, const DesignOptions& options,
                        const Doubt& doubt, DesignResult& result) {
  const auto complaint = [&](const char* what) {
    return fmt::format("{}, and {} not stand a simulation in more digits. {}", doubt.cause, what,
                       doubt.remedy);
  };
  if (!result.feasible())
    return boundStands(problem, result) ? "" : complaint("the bound found does");

  AuditReport report = audited(problem, result, result.amplitudes);
  if (report.lambda_min > 0.0 && report.lambda_min < 1.0 - kShort) {
    // A little more, for the root and the products round; it costs less than any bound is known to.
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
  restate(options, claimed, doubt, result);
  return "";
}

}  // namespace explore_opt
