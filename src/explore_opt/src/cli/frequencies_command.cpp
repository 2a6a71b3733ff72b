#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "checks.hpp"
#include "commands.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/frequency_choice.hpp"
#include "json_matrix.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

const char* const kFrequenciesHelp = R"(Example:
  echo '{"A": [[0.98, 0.19], [-0.19, 0.98]], "B": [[0], [0.2]], "T": 500, "phase": "cos", "gamma_w": 1, "D_des": 10}' > system.json
  explore_opt frequencies system.json --lines 3 --problem problem.json --out bode.json
  explore_opt design problem.json --out design.json
harmonics: the lines chosen, shares: their parts of the power. bode: the data of the picture: frequency [cycles per sample],
gain and phase [rad] (a column for each state and input), power (of the best steady-state signal).
Only entries of [A B] that "known" leaves open count. Lines already in the file play no part. Exit code 0: done; 3: unstable (add K), or nothing excites; 2: bad input.)";
namespace {

using nlohmann::ordered_json;

ordered_json toJson(const FrequencyChoice& choice, int T) {
  ordered_json out = {{"harmonics", choice.harmonics}, {"frequencies", ordered_json::array()}};
  for (const int h : choice.harmonics) out["frequencies"].push_back(static_cast<double>(h) / T);
  out["shares"] = choice.shares;
  std::vector<double> frequency;
  for (const int h : choice.grid) frequency.push_back(static_cast<double>(h) / T);
  out["bode"] = {{"frequency", frequency},
                 {"gain", matrixToJson(choice.gain)},
                 {"phase", matrixToJson(choice.phase)},
                 {"power", std::vector<double>(choice.power.begin(), choice.power.end())}};
  return out;
}

}  // namespace

int runFrequencies(const FrequenciesSettings& settings) {
  auto json = parseJson(quad_support::readFile(settings.system), settings.system);
  if (json.is_object()) {
    json.erase("frequencies");
    json["harmonics"] = {1};  // any line: the choice does not look at it
  }
  const ExplorationProblem problem = problemFromJson(json.dump(), settings.system);
  FrequencyOptions options = settings.options;
  if (!settings.band.empty()) {
    options.band_low = settings.band.front();
    options.band_high = settings.band.back();
  }
  const FrequencyChoice choice =
      withName(settings.system, [&] { return chooseFrequencies(problem, options); });
  if (!settings.problem.empty()) {
    json["harmonics"] = choice.harmonics;
    writeAnswer(settings.problem, prettyJson(json));
  }
  writeAnswer(settings.out, prettyJson(toJson(choice, problem.lines.num_samples)));
  return quad_support::kDone;
}

}  // namespace explore_opt
