#include "explore_opt/design_json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "amplitude_tables.hpp"
#include "json_matrix.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using quad_support::ConfigError;

const std::set<std::string> kKeys = {"A",     "B",     "T",     "harmonics",  "frequencies",
                                     "phase", "cost",  "K",     "gamma_w",    "D_des",
                                     "x0",    "u_max", "known", "experiments"};

/// Reads the values of one problem; every complaint names source and key.
class Reader {
 public:
  Reader(const json& object, std::string source) : object_(object), source_(std::move(source)) {}

  bool has(const std::string& key) const { return object_.contains(key); }

  const json& at(const std::string& key) const {
    if (!has(key)) fail(key, "is missing");
    return object_.at(key);
  }

  Eigen::MatrixXd matrix(const std::string& key) const {
    return matrixFromJson(at(key), source_ + ": " + key);
  }

  double number(const std::string& key) const {
    if (!at(key).is_number()) fail(key, fmt::format("= {}; must be a number", at(key).dump()));
    return at(key).get<double>();
  }

  int integer(const json& value, const std::string& key) const {
    const bool fits =
        value.is_number_integer() && value.get<double>() >= 0.0 && value.get<double>() <= 1e9;
    if (!fits) fail(key, fmt::format("= {}; must be a whole number, 0 to 1e9", value.dump()));
    return value.get<int>();
  }

  std::vector<double> numbers(const std::string& key) const {
    const json& list = array(key);
    std::vector<double> values;
    for (const json& value : list) {
      if (!value.is_number()) fail(key, fmt::format("holds {}; must hold numbers", value.dump()));
      values.push_back(value.get<double>());
    }
    return values;
  }

  std::vector<int> integers(const std::string& key) const {
    std::vector<int> values;
    for (const json& value : array(key))
      values.push_back(integer(value, fmt::format("{}[{}]", key, values.size())));
    return values;
  }

  /// [A B] with null where an entry is unknown, which becomes NaN.
  Eigen::MatrixXd matrixWithGaps(const std::string& key) const {
    json rows = at(key);
    std::vector<std::pair<std::size_t, std::size_t>> gaps;
    for (std::size_t i = 0; rows.is_array() && i < rows.size(); ++i) {
      for (std::size_t j = 0; rows[i].is_array() && j < rows[i].size(); ++j) {
        if (!rows[i][j].is_null()) continue;
        rows[i][j] = 0.0;
        gaps.emplace_back(i, j);
      }
    }
    Eigen::MatrixXd m = matrixFromJson(rows, source_ + ": " + key);
    for (const auto& [i, j] : gaps) {
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::numeric_limits<double>::quiet_NaN();
    }
    return m;
  }

  Eigen::VectorXd vector(const std::string& key) const {
    if (at(key).is_number()) return Eigen::VectorXd::Constant(1, number(key));
    const std::vector<double> values = numbers(key);
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  }

  std::string text(const std::string& key) const {
    if (!at(key).is_string()) fail(key, fmt::format("= {}; must be a text", at(key).dump()));
    return at(key).get<std::string>();
  }

  void refuseUnknownKeys() const {
    for (const auto& item : object_.items()) {
      if (kKeys.count(item.key()) == 0) {
        fail(item.key(),
             "is not a key; there are A, B, T, harmonics, frequencies, phase, gamma_w, D_des, x0, "
             "K, cost, known, u_max, experiments");
      }
    }
  }

 private:
  const json& array(const std::string& key) const {
    if (!at(key).is_array()) fail(key, fmt::format("= {}; must be a list", at(key).dump()));
    return at(key);
  }

  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw ConfigError(fmt::format("{}: {} {}", source_, key, what));
  }

  const json& object_;
  std::string source_;
};

ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json amplitudesToJson(const Eigen::MatrixXd& amplitudes, Phase phase) {
  if (phase != Phase::kBoth) return matrixToJson(amplitudes);
  const Eigen::Index L = amplitudes.rows() / 2;
  return {{"cos", matrixToJson(amplitudes.topRows(L))},
          {"sin", matrixToJson(amplitudes.bottomRows(L))}};
}

/// The amplitudes of each run.
ordered_json runsToJson(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes) {
  ordered_json runs = ordered_json::array();
  const Eigen::Index rows = amplitudes.rows() / problem.experiments;
  for (int i = 0; i < problem.experiments; ++i)
    runs.push_back(amplitudesToJson(amplitudes.middleRows(i * rows, rows), problem.phase));
  return runs;
}

ordered_json peakMultipliersToJson(const DesignResult& result) {
  ordered_json list = ordered_json::array();
  for (const PeakMultiplier& peak : result.peak_multipliers) {
    ordered_json entry = {{"sample", peak.sample}};
    entry["input"] = peak.input >= 0 ? ordered_json(peak.input) : ordered_json(nullptr);
    entry["value"] = peak.value;
    list.push_back(entry);
  }
  return list;
}

}  // namespace

ExplorationProblem problemFromJson(const std::string& text, const std::string& source) {
  const json object = parseJson(text, source);
  const Reader in(object, source);
  if (!object.is_object())
    throw ConfigError(source + ": must hold one JSON object, { \"A\": ..., ... }");
  in.refuseUnknownKeys();
  ExplorationProblem problem;
  problem.A = in.matrix("A");
  problem.B = in.matrix("B");
  problem.lines.num_samples = in.integer(in.at("T"), "T");
  if (in.has("harmonics")) problem.lines.harmonics = in.integers("harmonics");
  if (in.has("frequencies")) problem.lines.frequencies = in.numbers("frequencies");
  problem.gamma_w = in.number("gamma_w");
  if (!in.at("D_des").is_number() && !in.at("D_des").is_array()) {
    throw ConfigError(
        fmt::format("{}: D_des = {}; must be a number or a list of rows, [[...], ...]", source,
                    in.at("D_des").dump()));
  }
  problem.D_des = in.at("D_des").is_number() ? Eigen::MatrixXd::Constant(1, 1, in.number("D_des"))
                                             : in.matrix("D_des");
  if (in.has("x0")) problem.x0 = in.vector("x0");
  if (in.has("K")) problem.K = in.matrix("K");
  if (in.has("known")) problem.known = in.matrixWithGaps("known");
  if (in.has("u_max")) problem.u_max = in.vector("u_max");
  if (in.has("experiments")) problem.experiments = in.integer(in.at("experiments"), "experiments");
  try {
    problem.phase = phaseFromString(in.text("phase"));
    if (in.has("cost")) problem.cost = costFromString(in.text("cost"));
    validate(problem);
  } catch (const quad_support::DataError& e) {
    throw ConfigError(fmt::format("{}: {}", source, e.what()));
  }
  return problem;
}

ordered_json designToJson(const ExplorationProblem& problem, const DesignResult& result) {
  ordered_json out;
  out["status"] = toString(result.status);
  out["method"] = toString(result.method);
  out["message"] = result.message;
  const bool one = problem.experiments == 1;
  out["amplitudes"] = one && result.feasible() ? amplitudesToJson(result.amplitudes, problem.phase)
                                               : ordered_json(nullptr);
  if (!one && result.feasible()) out["experiments"] = runsToJson(problem, result.amplitudes);
  out["gamma_e"] = numberOrNull(result.gamma_e);
  out["lower_bound"] =
      result.lower_bound > 0.0 ? numberOrNull(result.lower_bound) : ordered_json(nullptr);
  out["gap"] = numberOrNull(result.gap);
  out["certificate"] =
      result.certificate.size() > 0 ? matrixToJson(result.certificate) : ordered_json(nullptr);
  out["multiplier"] =
      result.multiplier.size() > 0 ? matrixToJson(result.multiplier) : ordered_json(nullptr);
  out["multiplier_root"] = result.multiplier_root.size() > 0 ? matrixToJson(result.multiplier_root)
                                                             : ordered_json(nullptr);
  if (problem.u_max.size() > 0) {
    out["peak_multipliers"] = peakMultipliersToJson(result);
    out["peak"] = numberOrNull(result.peak);
  }
  out["relaxation_rank"] = result.relaxation_rank;
  out["lambda_min"] = numberOrNull(result.lambda_min);
  out["inner_gap"] =
      result.method == DesignMethod::kMm ? numberOrNull(result.inner_gap) : ordered_json(nullptr);
  out["iterations"] = ordered_json::array();
  for (const DesignIteration& iteration : result.iterations) {
    out["iterations"].push_back(
        {{"gamma_e", iteration.gamma_e},
         {"step", iteration.step},
         {"inner_gap", iteration.inner_gap},
         {"amplitudes", one ? amplitudesToJson(iteration.amplitudes, problem.phase)
                            : runsToJson(problem, iteration.amplitudes)}});
  }
  out["seconds"] = result.seconds;
  return out;
}

Eigen::MatrixXd amplitudesFromJson(const std::string& text, const std::string& source,
                                   const ExplorationProblem& problem) {
  const json value = parseJson(text, source);
  const bool answer =
      value.is_object() && (value.contains("amplitudes") || value.contains("experiments"));
  const Eigen::MatrixXd m = answer ? answeredAmplitudes(value, problem.phase, source)
                                   : amplitudeTables(value, problem.phase, source);
  const int carriers = numCarriers(problem.lines, problem.phase);
  if (m.rows() != Eigen::Index{carriers} * problem.experiments || m.cols() != problem.numInputs()) {
    throw ConfigError(fmt::format("{}: amplitudes are {} x {}; must be {} carriers x {} inputs{}",
                                  source, m.rows(), m.cols(), carriers, problem.numInputs(),
                                  problem.experiments == 1
                                      ? ""
                                      : fmt::format(" for each of {} experiments, one table below "
                                                    "the other",
                                                    problem.experiments)));
  }
  return m;
}

}  // namespace explore_opt
