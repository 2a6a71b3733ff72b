#include "amplitude_tables.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "json_matrix.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using nlohmann::json;
using quad_support::ConfigError;

/// The rows, with both phases those of the cosines and below them those of the sines.
Eigen::MatrixXd table(const json& value, Phase phase, const std::string& source) {
  if (phase != Phase::kBoth) return matrixFromJson(value, source + ": amplitudes");
  if (!value.is_object() || !value.contains("cos") || !value.contains("sin")) {
    throw ConfigError(
        fmt::format("{}: amplitudes need \"cos\" and \"sin\", for phase is both", source));
  }
  const Eigen::MatrixXd cosines = matrixFromJson(value.at("cos"), source + ": amplitudes cos"),
                        sines = matrixFromJson(value.at("sin"), source + ": amplitudes sin");
  if (cosines.rows() != sines.rows() || cosines.cols() != sines.cols())
    throw ConfigError(fmt::format("{}: amplitudes have unequal cos and sin", source));
  Eigen::MatrixXd both(2 * cosines.rows(), cosines.cols());
  both << cosines, sines;
  return both;
}

}  // namespace

Eigen::MatrixXd amplitudeTables(const json& value, Phase phase, const std::string& source) {
  const bool list =
      value.is_array() && !value.empty() &&
      (value.front().is_object() ||
       (value.front().is_array() && !value.front().empty() && value.front().front().is_array()));
  if (!list) return table(value, phase, source);
  Eigen::MatrixXd all;
  for (const json& run : value) {
    const Eigen::MatrixXd one = table(run, phase, source);
    if (all.size() > 0 && one.cols() != all.cols())
      throw ConfigError(fmt::format("{}: amplitudes of the experiments differ in shape", source));
    Eigen::MatrixXd longer(all.rows() + one.rows(), one.cols());
    if (all.size() > 0) longer.topRows(all.rows()) = all;
    longer.bottomRows(one.rows()) = one;
    all = longer;
  }
  return all;
}

Eigen::MatrixXd answeredAmplitudes(const json& answer, Phase phase, const std::string& source) {
  const auto has = [&](const char* key) {
    return answer.contains(key) && !answer.at(key).is_null();
  };
  if (has("amplitudes") && has("experiments"))
    throw ConfigError(source + ": has amplitudes and experiments; give one of the two");
  const char* key = has("experiments") ? "experiments" : "amplitudes";
  if (!has(key)) throw ConfigError(fmt::format("{}: {} are missing", source, key));
  return amplitudeTables(answer.at(key), phase, source);
}

}  // namespace explore_opt
