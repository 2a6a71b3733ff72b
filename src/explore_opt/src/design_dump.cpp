#include "explore_opt/design_dump.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "explore_opt/design_json.hpp"
#include "json_matrix.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using quad_support::ConfigError;

ordered_json optionsToJson(const DesignOptions& o) {
  return {{"method", toString(o.method)},
          {"gap_tolerance", o.gap_tolerance},
          {"random_starts", o.random_starts},
          {"seed", o.seed},
          {"initial_amplitudes",
           std::vector<double>(o.initial_amplitudes.begin(), o.initial_amplitudes.end())},
          {"cost_tolerance", o.cost_tolerance},
          {"step_tolerance", o.step_tolerance},
          {"max_iterations", o.max_iterations},
          {"inner_gap", o.inner_gap},
          {"extrapolate", o.extrapolate}};
}

int wholeNumber(const json& in, const char* key, int largest) {
  const auto value = in.at(key).get<double>();
  if (!(value >= 0.0 && value <= largest && value == std::floor(value)))
    throw ConfigError(
        fmt::format("options: {} = {}; must be a whole number, 0 to {}", key, value, largest));
  return static_cast<int>(value);
}

DesignOptions optionsFromJson(const json& in) {
  DesignOptions o;
  o.method = methodFromString(in.at("method").get<std::string>());
  o.gap_tolerance = in.at("gap_tolerance").get<double>();
  o.random_starts = wholeNumber(in, "random_starts", 100000);
  o.seed = in.at("seed").get<std::uint64_t>();
  const auto initial = in.at("initial_amplitudes").get<std::vector<double>>();
  o.initial_amplitudes =
      Eigen::Map<const Eigen::VectorXd>(initial.data(), static_cast<Eigen::Index>(initial.size()));
  o.cost_tolerance = in.at("cost_tolerance").get<double>();
  o.step_tolerance = in.at("step_tolerance").get<double>();
  o.max_iterations = wholeNumber(in, "max_iterations", 1000000000);
  o.inner_gap = in.at("inner_gap").get<double>();
  o.extrapolate = in.at("extrapolate").get<bool>();
  return o;
}

}  // namespace

std::string dumpDesign(const std::string& problem_text, const DesignOptions& options,
                       const DesignResult& result) {
  const ExplorationProblem problem = problemFromJson(problem_text, "problem");
  return prettyJson({{"problem", ordered_json::parse(problem_text)},
                     {"options", optionsToJson(options)},
                     {"answer", designToJson(problem, result)}});
}

bool Replay::agrees() const {
  if (toString(result.status) != recorded_status) return false;
  if (!std::isfinite(recorded_gamma_e)) return !std::isfinite(result.gamma_e);
  return std::abs(result.gamma_e - recorded_gamma_e) <= 1e-9 * recorded_gamma_e;
}

Replay replayDesign(const std::string& dump_text, const std::string& source) {
  const json dump = parseJson(dump_text, source);
  Replay replay;
  DesignOptions options;
  try {
    replay.problem = problemFromJson(dump.at("problem").dump(), source + ": problem");
    options = optionsFromJson(dump.at("options"));
    const json& answer = dump.at("answer");
    replay.recorded_status = answer.at("status").get<std::string>();
    replay.recorded_gamma_e = answer.at("gamma_e").is_null()
                                  ? std::numeric_limits<double>::quiet_NaN()
                                  : answer.at("gamma_e").get<double>();
  } catch (const json::exception& e) {
    throw ConfigError(
        fmt::format("{}: is no dump of `explore_opt design --dump`: {}", source, e.what()));
  }
  replay.result = designExploration(replay.problem, options);
  return replay;
}

}  // namespace explore_opt
