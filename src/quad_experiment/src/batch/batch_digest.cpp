#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <map>

#include "quad_experiment/batch.hpp"
#include "quad_experiment/batch_row.hpp"
#include "quad_experiment/ensemble.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_experiment {
namespace {

/// The columns worth a line, and how often a thing is true.
const std::vector<std::string> kQuantiles = {"error_norm",  "m_hat",        "lambda_min_S",
                                             "lambda_D_bd", "lambda_D_exp", "gamma_w_exp",
                                             "gamma_w_sim", "signal_energy"};
const std::vector<std::pair<std::string, std::string>> kShares = {
    {"gamma_w_valid", "gamma_w,exp <= gamma_w (the truth lies in the set)"},
    {"gamma_w_falsified", "gamma_w falsified by the data"},
    {"exploration_condition", "exploration condition met"},
    {"objective_met", "objective met"}};

struct Table {
  std::int64_t runs = 0;
  std::map<std::string, std::int64_t> statuses;
  std::map<std::string, std::vector<double>> values;  ///< of the columns above, where not empty
};

bool isOfInterest(const std::string& column) {
  const auto dot = column.find('.');
  const std::string part = column.substr(0, dot);
  if (part != "targeted" && part != "random") return false;
  const std::string name = column.substr(dot + 1);
  const bool share =
      std::any_of(kShares.begin(), kShares.end(), [&](const auto& s) { return s.first == name; });
  return share || std::find(kQuantiles.begin(), kQuantiles.end(), name) != kQuantiles.end();
}

Table readTable(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!in || !std::getline(in, line)) throw quad_support::EnvironmentError("cannot read " + path);
  const std::vector<std::string> columns = splitBatchRow(line);
  Table table;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = splitBatchRow(line);
    if (cells.size() != columns.size())
      throw quad_support::DataError(fmt::format("{}: row {} has {} cells, not {}", path,
                                                table.runs + 1, cells.size(), columns.size()));
    ++table.runs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns[i] == "status") ++table.statuses[cells[i]];
      if (!cells[i].empty() && isOfInterest(columns[i]))
        table.values[columns[i]].push_back(quad_support::parseDouble(cells[i]));
    }
  }
  for (auto& entry : table.values) std::sort(entry.second.begin(), entry.second.end());
  return table;
}

double share(const std::vector<double>& zeros_and_ones) {
  double sum = 0.0;
  for (const double value : zeros_and_ones) sum += value;
  return sum / static_cast<double>(zeros_and_ones.size());
}

std::string flightDigest(const Table& table, const std::string& flight) {
  const auto valid = table.values.find(flight + ".gamma_w_valid");
  if (valid == table.values.end()) return "";
  std::string text = fmt::format("\n{:<22} {:>12} {:>12} {:>12}   of {} flights\n", flight, "5 %",
                                 "median", "95 %", valid->second.size());
  for (const std::string& name : kQuantiles) {
    const auto it = table.values.find(flight + "." + name);
    if (it == table.values.end()) continue;
    text +=
        fmt::format("  {:<20} {:>12.5g} {:>12.5g} {:>12.5g}{}\n", name, quantile(it->second, 0.05),
                    quantile(it->second, 0.5), quantile(it->second, 0.95),
                    name == "lambda_D_bd" ? "   (rises as data get worse: no rank)" : "");
  }
  for (const auto& [name, label] : kShares)
    text += fmt::format("  {:>5.1f} %  {}\n", 100.0 * share(table.values.at(flight + "." + name)),
                        label);
  return text;
}

}  // namespace

std::string batchDigest(const std::string& results_csv) {
  const Table table = readTable(results_csv);
  std::string text = fmt::format("{} runs:", table.runs);
  for (const auto& [status, count] : table.statuses) text += fmt::format(" {} {}", status, count);
  return text + "\n" + flightDigest(table, "targeted") + flightDigest(table, "random");
}

}  // namespace quad_experiment
