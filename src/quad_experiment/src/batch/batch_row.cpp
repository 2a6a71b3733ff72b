#include "quad_experiment/batch_row.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_experiment {
namespace {

using Json = nlohmann::ordered_json;

struct Column {
  std::string name;
  Json::json_pointer at;  ///< in summary.json
};

/// The numbers of summary.json that describe the experiment; nothing that depends on the clock.
const std::vector<Column>& summaryColumns() {
  static const std::vector<Column> all = [] {
    std::vector<Column> c;
    const auto add = [&](const std::string& part, const std::string& name, const std::string& at) {
      c.push_back({part + "." + name, Json::json_pointer("/" + part + "/" + at)});
    };
    for (const char* key : {"gamma_e", "lower_bound", "gap"}) add("design", key, key);
    for (const char* key : {"error_norm", "lambda_D0", "gamma_w_true", "gamma_w_compensated"})
      add("initial", key, key);
    for (const char* key : {"mean", "std", "max_abs_error"}) add("time", key, key);
    for (const char* flight : {"targeted", "random"}) {
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j)
          add(flight, fmt::format("A{}{}", i + 1, j + 1), fmt::format("A/{}/{}", i, j));
      }
      add(flight, "B1", "B/0/0");
      add(flight, "B2", "B/1/0");
      for (const char* key : {"dT_hat",
                              "m_hat",
                              "error_norm",
                              "residual_energy",
                              "G",
                              "lambda_D_bd",
                              "lambda_D_exp",
                              "objective",
                              "signal_energy",
                              "gamma_w_exp",
                              "gamma_w_sim",
                              "lambda_min_S",
                              "truth_in_set",
                              "gamma_w_valid",
                              "gamma_w_falsified",
                              "exploration_condition",
                              "objective_met",
                              "max_tilt",
                              "max_lateral_speed",
                              "min_altitude",
                              "clamped_commands"})
        add(flight, key, key);
    }
    return c;
  }();
  return all;
}

/// Numbers in shortest form, true and false as 1 and 0, what does not exist as an empty cell.
std::string cell(const Json& summary, const Json::json_pointer& at) {
  if (!summary.contains(at)) return "";
  const Json& value = summary.at(at);
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  return value.is_number() ? quad_support::shortest(value.get<double>()) : "";
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

std::string rowStart(const BatchSpec& spec, std::int64_t run, RunStatus status) {
  std::string row = fmt::format("{}", run);
  for (const auto& setting : spec.variedSettings(run)) row += "," + quoted(setting.value);
  return row + fmt::format(",{},{}", toString(status), exitCodeOf(status));
}

RunStatus statusOf(const Json& summary) {
  const Json& flight = summary.at("targeted");
  if (flight.at("gamma_w_falsified").get<bool>()) return RunStatus::kFalsified;
  if (!flight.at("exploration_condition").get<bool>()) return RunStatus::kConditionNotMet;
  return flight.at("objective_met").get<bool>() ? RunStatus::kOk : RunStatus::kObjectiveMissed;
}

Json flySummary(const ExperimentConfig& config, DesignMemory& designs) {
  const ExperimentPlan plan = planExperiment(config, &designs);
  InProcessPlant plant(config);
  return summaryJson(plan, flyExperiment(plan, {&plant}, "in_process"));
}

}  // namespace

const char* toString(RunStatus status) {
  switch (status) {
    case RunStatus::kOk:
      return "ok";
    case RunStatus::kFalsified:
      return "falsified";
    case RunStatus::kConditionNotMet:
      return "condition_not_met";
    case RunStatus::kObjectiveMissed:
      return "objective_missed";
    case RunStatus::kInfeasible:
      return "infeasible";
    case RunStatus::kGroundContact:
      return "ground_contact";
    case RunStatus::kDiverged:
      return "diverged";
    case RunStatus::kBadInput:
      return "bad_input";
    case RunStatus::kCrashed:
      return "crashed";
    case RunStatus::kTimeout:
      return "timeout";
  }
  return "";
}

int exitCodeOf(RunStatus status) {
  switch (status) {
    case RunStatus::kOk:
      return quad_support::kDone;
    case RunStatus::kFalsified:
    case RunStatus::kConditionNotMet:
    case RunStatus::kObjectiveMissed:
    case RunStatus::kInfeasible:
      return quad_support::kNegativeAnswer;
    case RunStatus::kGroundContact:
    case RunStatus::kDiverged:
      return quad_support::kSimulationFailed;
    case RunStatus::kBadInput:
      return quad_support::kBadInput;
    case RunStatus::kCrashed:
    case RunStatus::kTimeout:
      return quad_support::kEnvironment;
  }
  return quad_support::kEnvironment;
}

std::vector<std::string> batchColumns(const BatchSpec& spec) {
  std::vector<std::string> names = {"run"};
  for (const Variation& v : spec.vary) names.push_back(v.key);
  names.insert(names.end(), {"status", "exit_code"});
  for (const Column& c : summaryColumns()) names.push_back(c.name);
  return names;
}

std::string batchRow(const BatchSpec& spec, std::int64_t run, const Json& summary) {
  std::string row = rowStart(spec, run, statusOf(summary));
  for (const Column& c : summaryColumns()) row += "," + cell(summary, c.at);
  return row + "\n";
}

std::string batchRow(const BatchSpec& spec, std::int64_t run, RunStatus status) {
  return rowStart(spec, run, status) + std::string(summaryColumns().size(), ',') + "\n";
}

std::string flyBatchRun(const BatchSpec& spec, std::int64_t run, DesignMemory& designs) {
  try {
    return batchRow(spec, run, flySummary(spec.experiment(run), designs));
  } catch (const std::invalid_argument&) {
    return batchRow(spec, run, RunStatus::kBadInput);
  } catch (const quad_support::NegativeAnswer&) {
    return batchRow(spec, run, RunStatus::kInfeasible);
  } catch (const GroundContact&) {
    return batchRow(spec, run, RunStatus::kGroundContact);
  } catch (const quad_support::SimulationError&) {
    return batchRow(spec, run, RunStatus::kDiverged);
  }
}

std::vector<std::string> splitBatchRow(std::string_view row) {
  std::vector<std::string> cells(1);
  bool inside = false;
  for (std::size_t i = 0; i < row.size() && (inside || row[i] != '\n'); ++i) {
    if (row[i] == '"') {
      if (inside && i + 1 < row.size() && row[i + 1] == '"')
        cells.back() += row[++i];
      else
        inside = !inside;
    } else if (row[i] == ',' && !inside) {
      cells.emplace_back();
    } else {
      cells.back() += row[i];
    }
  }
  return cells;
}

}  // namespace quad_experiment
