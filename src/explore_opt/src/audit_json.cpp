#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "amplitude_tables.hpp"
#include "explore_opt/audit.hpp"
#include "json_matrix.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using quad_support::ConfigError;

double number(const json& object, const char* key, const std::string& source) {
  if (!object.contains(key) || !object.at(key).is_number()) {
    throw ConfigError(
        fmt::format("{}: {} = {}; must be a number (there is nothing to audit in a "
                    "design that failed)",
                    source, key, object.contains(key) ? object.at(key).dump() : "missing"));
  }
  return object.at(key).get<double>();
}

int wholeNumber(const json& object, const char* key, const std::string& source) {
  const double value = number(object, key, source);
  if (!(value >= -1.0 && value <= 1e9 && value == std::floor(value)))
    throw ConfigError(fmt::format("{}: {} = {}; must be a whole number", source, key, value));
  return static_cast<int>(value);
}

Eigen::MatrixXd optionalMatrix(const json& object, const char* key, const std::string& source) {
  if (!object.contains(key) || object.at(key).is_null() || object.at(key).empty()) return {};
  return matrixFromJson(object.at(key), source + ": " + key);
}

}  // namespace

DesignClaims claimsFromJson(const std::string& text, const std::string& source,
                            const ExplorationProblem& problem) {
  const json object = parseJson(text, source);
  if (!object.is_object()) throw ConfigError(source + ": must be the answer of design, {...}");
  DesignClaims claims;
  claims.gamma_e = number(object, "gamma_e", source);
  claims.lower_bound = number(object, "lower_bound", source);
  claims.gap = number(object, "gap", source);
  if (object.contains("lambda_min") && !object.at("lambda_min").is_null())
    claims.lambda_min = number(object, "lambda_min", source);
  if (object.contains("status")) {
    if (!object.at("status").is_string())
      throw ConfigError(fmt::format("{}: status = {}; must be a text, as design writes it", source,
                                    object.at("status").dump()));
    claims.status = object.at("status").get<std::string>();
  }
  claims.amplitudes = answeredAmplitudes(object, problem.phase, source);
  claims.certificate = optionalMatrix(object, "certificate", source);
  claims.multiplier = optionalMatrix(object, "multiplier", source);
  claims.multiplier_root = optionalMatrix(object, "multiplier_root", source);
  if (!object.contains("peak_multipliers")) return claims;
  if (!object.at("peak_multipliers").is_array())
    throw ConfigError(fmt::format("{}: peak_multipliers must be a list", source));
  for (const json& peak : object.at("peak_multipliers")) {
    claims.peak_multipliers.push_back({wholeNumber(peak, "sample", source),
                                       peak.contains("input") && !peak.at("input").is_null()
                                           ? wholeNumber(peak, "input", source)
                                           : -1,
                                       number(peak, "value", source)});
  }
  return claims;
}

ordered_json auditToJson(const AuditReport& report) {
  const auto orNull = [](double v) {
    return std::isfinite(v) ? ordered_json(v) : ordered_json(nullptr);
  };
  ordered_json out = {
      {"passed", report.passed()},         {"lambda_min", orNull(report.lambda_min)},
      {"gamma_e", orNull(report.gamma_e)}, {"lower_bound", orNull(report.lower_bound)},
      {"gap", orNull(report.gap)},         {"peak", orNull(report.peak)},
      {"checks", ordered_json::array()}};
  for (const AuditCheck& check : report.checks) {
    out["checks"].push_back(
        {{"name", check.name}, {"passed", check.passed}, {"finding", check.finding}});
  }
  return out;
}

}  // namespace explore_opt
