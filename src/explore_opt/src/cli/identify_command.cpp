#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "checks.hpp"
#include "commands.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/identification.hpp"
#include "explore_opt/identification_json.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/csv_table.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt {

const char* const kIdentifyHelp = R"(Example:
  printf 'x,u\n0,1\n0.5,1\n0.76,-1\n-0.13,-1\n-0.55,\n' > data.csv
  explore_opt identify data.csv --states x --inputs u --gamma-w 0.01 --D 20 --function 'gain = B1/A11'
  printf '[[0.5, 0.5]]' > candidate.json
  explore_opt identify data.csv data.csv --states x --inputs u --gamma-w 0.01,0.02 --contains candidate.json
Row k holds x_k and u_k; the last row's inputs are ignored. known.json is [A B] with null where unknown.
Several files are several experiments on one system: each is judged, then all together (G, lambda_D_bd and intervals are
those of an ellipsoid around the intersection of their sets). lower, upper: the interval of each entry of [A B].
Exit code 0: done; 3: gamma_w falsified, condition not met, candidate not a member, or data not exciting; 2: bad input.)";
namespace {

/// A number on the command line or a JSON file with a number or a matrix.
Eigen::MatrixXd readCloseness(const std::string& text) {
  double number = 0.0;
  try {
    number = quad_support::parseDouble(text);
  } catch (const std::invalid_argument&) {  // then it is a file
    return closenessFromJson(quad_support::readFile(text), text);
  }
  const Eigen::MatrixXd D = Eigen::MatrixXd::Constant(1, 1, number);
  requireCloseness(D, "--D");
  return D;
}

std::vector<DataSet> readData(const IdentifySettings& settings) {
  const auto& bounds = settings.gamma_w;
  if (bounds.size() != 1 && bounds.size() != settings.data.size()) {
    throw quad_support::DataError(
        fmt::format("--gamma-w has {} values for {} files; give one for all or one each",
                    bounds.size(), settings.data.size()));
  }
  std::vector<DataSet> sets;
  for (std::size_t i = 0; i < settings.data.size(); ++i) {
    const auto table = quad_support::CsvTable::read(settings.data[i]);
    sets.push_back(selectData(table, settings.data[i], settings.states, settings.inputs,
                              settings.where, bounds[bounds.size() == 1 ? 0 : i]));
  }
  return sets;
}

}  // namespace

int runIdentify(const IdentifySettings& settings) {
  IdentificationRequest request;
  request.functions = settings.functions;
  if (!settings.closeness.empty()) request.closeness = readCloseness(settings.closeness);
  if (!settings.known.empty())
    request.known = knownFromJson(quad_support::readFile(settings.known), settings.known);
  if (!settings.candidate.empty()) {
    request.candidate =
        thetaFromJson(quad_support::readFile(settings.candidate), settings.candidate);
  }
  const std::vector<DataSet> data = readData(settings);
  if (request.closeness) {
    const auto nx = static_cast<int>(settings.states.size()),
               nu = static_cast<int>(settings.inputs.size());
    withName("--D " + settings.closeness,
             [&] { return fullCloseness(*request.closeness, nx, nx + nu); });
  }
  const Identification result = identify(data, request);
  writeAnswer(settings.out, prettyJson(identificationToJson(result)));
  const std::string text = complaint(result);
  if (text.empty()) return quad_support::kDone;
  std::fprintf(stderr, "explore_opt: %s\n", text.c_str());
  return quad_support::kNegativeAnswer;
}

}  // namespace explore_opt
