#include <fmt/core.h>

#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/least_squares.hpp"
#include "explore_opt/set_membership.hpp"
#include "explore_opt/structured_least_squares.hpp"
#include "json_matrix.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/csv_table.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using nlohmann::ordered_json;
using quad_support::CsvTable;
using quad_support::DataError;

constexpr const char* kHelp = R"(Example:
  printf 'x,u\n0,1\n0.5,1\n0.76,-1\n-0.13,-1\n-0.55,\n' > data.csv
  explore_opt identify data.csv --states x --inputs u --gamma-w 0.01 --D 20
Row k holds x_k and u_k; the last row's inputs are ignored. known.json is [A B] with null where unknown.
Exit code 0: done; 3: gamma_w falsified, condition not met, or data not exciting; 2: bad input.)";

struct Settings {
  std::string data, where, closeness, known, out;
  std::vector<std::string> states, inputs;
  double gamma_w = 0.0;
};

/// What is reported of a fit, structured or not.
struct Verdict {
  bool exciting = false;
  double condition = 0.0;
  Eigen::VectorXd singular_values;
  MatrixXd Theta, information;
  double residual_energy = 0.0, G = 0.0, lambda_min = 0.0;
  std::optional<double>
      margin;               ///< largest G the condition allows; none if no closeness is asked for
  std::vector<Entry> free;  ///< structured only

  bool falsified() const { return exciting && G < 0.0; }
  bool conditionMet() const { return exciting && !falsified() && margin && *margin >= G; }
};

/// Rows of the table where `where` ("column=value") holds, all without it. They must follow one
/// another.
std::vector<std::size_t> selectRows(const CsvTable& table, const Settings& settings) {
  const auto equals = settings.where.find('=');
  if (!settings.where.empty() && equals == std::string::npos) {
    throw DataError(fmt::format("--where {}; must be column=value", settings.where));
  }
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool wanted =
        settings.where.empty() ||
        table.text(row, settings.where.substr(0, equals)) == settings.where.substr(equals + 1);
    if (!wanted) continue;
    if (!rows.empty() && rows.back() + 1 != row) {
      throw DataError(
          fmt::format("{}: the rows with {} do not follow one another (gap after data row {})",
                      settings.data, settings.where, rows.back() + 1));
    }
    rows.push_back(row);
  }
  if (rows.size() < 2)
    throw DataError(
        fmt::format("{}: {} rows selected; at least 2 are needed", settings.data, rows.size()));
  return rows;
}

MatrixXd columns(const CsvTable& table, const std::vector<std::string>& names,
                 const std::vector<std::size_t>& rows, std::size_t count) {
  MatrixXd values(names.size(), count);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          table.number(rows[j], names[i]);
    }
  }
  return values;
}

/// A number on the command line or a JSON file with a number or a matrix.
MatrixXd readCloseness(const std::string& text) {
  try {
    return MatrixXd::Constant(1, 1, quad_support::parseDouble(text));
  } catch (const std::invalid_argument&) {  // then it is a file
  }
  const auto value = parseJson(quad_support::readFile(text), text);
  return value.is_number() ? MatrixXd::Constant(1, 1, value.get<double>())
                           : matrixFromJson(value, text);
}

MatrixXd readKnown(const std::string& path) {
  auto rows = parseJson(quad_support::readFile(path), path);
  MatrixXd unknown;
  if (rows.is_array() && !rows.empty() && rows.front().is_array())
    unknown.setZero(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; rows[i].is_array() && j < rows[i].size(); ++j) {
      if (!rows[i][j].is_null() || j >= static_cast<std::size_t>(unknown.cols())) continue;
      unknown(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::numeric_limits<double>::quiet_NaN();
      rows[i][j] = 0.0;
    }
  }
  const MatrixXd known = matrixFromJson(rows, path);
  return known + unknown;  // NaN where unknown
}

/// What both kinds of fit say before the set is judged.
template <class Fit>
Verdict startVerdict(const Fit& fit) {
  Verdict verdict{};
  verdict.exciting = fit.exciting;
  verdict.condition = fit.condition;
  verdict.singular_values = fit.singular_values;
  verdict.Theta = fit.Theta;
  verdict.information = fit.information;
  verdict.residual_energy = fit.residual_energy;
  return verdict;
}

Verdict identifyAll(const MatrixXd& X, const MatrixXd& U, const Settings& settings) {
  const LeastSquaresFit fit = fitLeastSquares(X, U);
  Verdict verdict = startVerdict(fit);
  if (!fit.exciting) return verdict;
  const FeasibleSet set = feasibleSet(fit, settings.gamma_w);
  verdict.G = set.G;
  verdict.lambda_min = set.lambda_min_S;
  if (!settings.closeness.empty())
    verdict.margin = informationMargin(set, readCloseness(settings.closeness));
  return verdict;
}

Verdict identifyStructured(const MatrixXd& X, const MatrixXd& U, const Settings& settings) {
  const StructuredFit fit = fitStructured(X, U, readKnown(settings.known));
  Verdict verdict = startVerdict(fit);
  verdict.free = fit.free;
  if (!fit.exciting) return verdict;
  verdict.G = settings.gamma_w - fit.residual_energy;
  const auto n = fit.root.cols();
  verdict.lambda_min = largestRadius(fit.root, MatrixXd::Identity(n, n));
  if (!settings.closeness.empty()) {
    verdict.margin =
        largestRadius(fit.root, restrictCloseness(readCloseness(settings.closeness), fit));
  }
  return verdict;
}

ordered_json toJson(const Verdict& v) {
  const ordered_json none = nullptr;
  ordered_json out;
  out["Theta"] = v.exciting ? matrixToJson(v.Theta) : none;
  out["residual_energy"] = v.exciting ? ordered_json(v.residual_energy) : none;
  out["G"] = v.exciting ? ordered_json(v.G) : none;
  out["information"] = matrixToJson(v.information);
  out["lambda_D_bd"] = v.exciting && v.G > 0.0 ? ordered_json(v.lambda_min / v.G) : none;
  out["exploration_condition"] = v.margin || !v.exciting ? ordered_json(v.conditionMet()) : none;
  out["falsified"] = v.falsified();
  out["lambda_min_S"] = v.exciting ? ordered_json(v.lambda_min) : none;
  out["exciting"] = v.exciting;
  out["condition"] = v.condition;
  out["singular_values"] = std::vector<double>(v.singular_values.begin(), v.singular_values.end());
  if (!v.free.empty()) {
    out["free"] = ordered_json::array();
    for (const Entry& entry : v.free) out["free"].push_back({entry.row, entry.column});
  }
  return out;
}

/// Empty if the answer is positive.
std::string complaint(const Verdict& v, const Settings& settings) {
  if (!v.exciting) {
    return fmt::format(
        "the data do not determine [A B]: condition {:.3g} of the scaled regressor, smallest "
        "singular "
        "value {:.3g}; excite more",
        v.condition, v.singular_values.tail(1)(0));
  }
  if (v.falsified()) {
    return fmt::format(
        "gamma_w = {} is smaller than the residual energy {:.6g}, so G = {:.6g} < 0 and no "
        "parameter "
        "fits the data (Eq. 1.8). Raise --gamma-w or look at the data",
        settings.gamma_w, v.residual_energy, v.G);
  }
  if (v.margin && !v.conditionMet()) {
    return fmt::format(
        "exploration condition not met: the data guarantee the desired closeness for G <= {:.6g}, "
        "but "
        "G = {:.6g} (Eq. 1.10)",
        *v.margin, v.G);
  }
  return {};
}

int identify(const Settings& settings) {
  if (!(settings.gamma_w > 0.0 && settings.gamma_w < std::numeric_limits<double>::infinity())) {
    throw DataError(fmt::format("--gamma-w {}; must be a finite number above 0", settings.gamma_w));
  }
  const CsvTable table = CsvTable::read(settings.data);
  const auto rows = selectRows(table, settings);
  const MatrixXd X = columns(table, settings.states, rows, rows.size());
  const MatrixXd U = columns(table, settings.inputs, rows, rows.size() - 1);
  const Verdict verdict =
      settings.known.empty() ? identifyAll(X, U, settings) : identifyStructured(X, U, settings);
  writeAnswer(settings.out, prettyJson(toJson(verdict)));
  const std::string text = complaint(verdict, settings);
  if (text.empty()) return quad_support::kDone;
  std::fprintf(stderr, "explore_opt: %s: %s\n", settings.data.c_str(), text.c_str());
  return quad_support::kNegativeAnswer;
}

}  // namespace

Action addIdentifyCommand(CLI::App& app) {
  const auto settings = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand(
      "identify", "Least squares and the set of parameters the data leave possible");
  command->footer(kHelp);
  command->add_option("data", settings->data, "Table in CSV, a row a sample, T+1 rows")->required();
  command->add_option("--states", settings->states, "Columns of the states")
      ->delimiter(',')
      ->required();
  command->add_option("--inputs", settings->inputs, "Columns of the inputs")
      ->delimiter(',')
      ->required();
  command->add_option("--where", settings->where, "Only the rows with column=value");
  command
      ->add_option("--gamma-w", settings->gamma_w,
                   "Bound on the energy of the disturbance, above 0")
      ->required();
  command->add_option("--D", settings->closeness,
                      "Desired closeness: a number or a JSON file; default: not judged");
  command->add_option("--known", settings->known,
                      "JSON file with the known entries of [A B], null where unknown");
  command->add_option("--out", settings->out, "File for the answer; default: standard output");
  return [settings] { return identify(*settings); };
}

}  // namespace explore_opt
