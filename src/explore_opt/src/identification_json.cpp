#include "explore_opt/identification_json.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "explore_opt/identification.hpp"
#include "json_matrix.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using nlohmann::ordered_json;

ordered_json finiteOrNull(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json orNull(bool exists, const ordered_json& value) {
  return exists ? value : ordered_json(nullptr);
}

ordered_json excitationOf(const Estimate& e) {
  return {
      {"exciting", e.exciting},
      {"condition", finiteOrNull(e.condition)},
      {"singular_values", std::vector<double>(e.singular_values.begin(), e.singular_values.end())}};
}

ordered_json dataSetToJson(const Estimate& e) {
  ordered_json out = {{"name", e.name}};
  out["Theta"] = orNull(e.exciting, matrixToJson(e.Theta));
  out["residual_energy"] = orNull(e.exciting, e.residual_energy);
  out["G"] = orNull(e.exciting, e.set.G);
  out.update(excitationOf(e));
  return out;
}

ordered_json functionsToJson(const Identification& v) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < v.functions.size(); ++i) {
    const auto& interval = v.functions[i];
    ordered_json row = {{"name", v.function_names[i]}};
    row["value"] = interval ? finiteOrNull(interval->value) : ordered_json(nullptr);
    row["lower"] = interval ? finiteOrNull(interval->lower) : ordered_json(nullptr);
    row["upper"] = interval ? finiteOrNull(interval->upper) : ordered_json(nullptr);
    list.push_back(row);
  }
  return list;
}

}  // namespace

ordered_json identificationToJson(const Identification& v) {
  const Estimate& first = v.data_sets.front();
  const bool several = v.data_sets.size() > 1;
  const bool bounded = v.exciting && v.set.G > 0.0;
  ordered_json out;
  out["Theta"] = orNull(v.exciting, matrixToJson(v.Theta));
  out["residual_energy"] = orNull(v.exciting, v.set.gamma_w - v.set.G);
  if (!several && v.exciting) out["residual_energy"] = first.residual_energy;
  out["G"] = orNull(v.exciting, v.set.G);
  out["information"] = matrixToJson(v.exciting ? v.information : first.information);
  out["lambda_D_bd"] = orNull(bounded, v.set.lambda_min_S / v.set.G);
  out["exploration_condition"] = orNull(v.margin.has_value(), v.conditionMet());
  out["falsified"] = v.falsified();
  out["lambda_min_S"] = orNull(v.exciting, v.set.lambda_min_S);
  out["lower"] = orNull(v.lower.size() > 0, matrixToJson(v.lower));
  out["upper"] = orNull(v.upper.size() > 0, matrixToJson(v.upper));
  if (!v.function_names.empty()) out["functions"] = functionsToJson(v);
  if (v.candidate_distance) {
    out["candidate"] = {{"member", v.candidateIsMember()}, {"distance", *v.candidate_distance}};
  }
  if (!several) out.update(excitationOf(first));
  if (several) {
    out["exciting"] = v.exciting;
    out["weights"] = v.weights;
    out["data_sets"] = ordered_json::array();
    for (std::size_t i = 0; i < v.data_sets.size(); ++i) {
      ordered_json one = dataSetToJson(v.data_sets[i]);
      if (i < v.candidate_distances.size()) {
        one["candidate"] = {{"member", v.candidateIsMember(i)},
                            {"distance", v.candidate_distances[i]}};
      }
      out["data_sets"].push_back(one);
    }
  }
  if (!v.free.empty()) {
    out["free"] = ordered_json::array();
    for (const Entry& entry : v.free) out["free"].push_back({entry.row, entry.column});
  }
  return out;
}

Eigen::MatrixXd closenessFromJson(const std::string& text, const std::string& source) {
  const auto value = parseJson(text, source);
  const Eigen::MatrixXd D = value.is_number() ? Eigen::MatrixXd::Constant(1, 1, value.get<double>())
                                              : matrixFromJson(value, source);
  try {
    requireCloseness(D);
  } catch (const quad_support::DataError& e) {
    throw quad_support::ConfigError(fmt::format("{}: {}", source, e.what()));
  }
  return D;
}

Eigen::MatrixXd knownFromJson(const std::string& text, const std::string& source) {
  auto rows = parseJson(text, source);
  std::vector<Entry> unknown;
  for (std::size_t i = 0; rows.is_array() && i < rows.size(); ++i) {
    for (std::size_t j = 0; rows[i].is_array() && j < rows[i].size(); ++j) {
      if (!rows[i][j].is_null()) continue;
      unknown.push_back({static_cast<int>(i), static_cast<int>(j)});
      rows[i][j] = 0.0;
    }
  }
  Eigen::MatrixXd known = matrixFromJson(rows, source);  // checks the shape
  for (const Entry& entry : unknown)
    known(entry.row, entry.column) = std::numeric_limits<double>::quiet_NaN();
  return known;
}

Eigen::MatrixXd thetaFromJson(const std::string& text, const std::string& source) {
  const auto value = parseJson(text, source);
  const bool answer = value.is_object() && value.contains("Theta");
  return matrixFromJson(answer ? value.at("Theta") : value, source + ": [A B]");
}

}  // namespace explore_opt
