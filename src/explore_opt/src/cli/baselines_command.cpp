#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "checks.hpp"
#include "commands.hpp"
#include "explore_opt/baselines.hpp"
#include "explore_opt/design_json.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

const char* const kBaselinesHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt baselines problem.json --seeds 5 --out baselines.json
Every signal is scaled until the noise-free response of the nominal system meets the condition. Cost is what the design
minimises, gamma_e: sqrt(2 energy/T) of the input u = K x + e with "cost": "input"; else the norm of the amplitudes of signals
made of the problem's lines, and sqrt(2 energy/T) of others, which is the same on the grid (off it, those compare among
themselves only). u_max is not imposed on other signals. Random ones: median of the seeds. peak: of e. The table goes to
standard output with --out, else to standard error, and the JSON to standard output.
Exit code 0: done; 3: there is no targeted design to compare with; 2: bad input.)";
namespace {

using nlohmann::ordered_json;

ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json toJson(const BaselineCost& row, double targeted) {
  return {{"name", row.name},
          {"note", row.note},
          {"cost", numberOrNull(row.cost)},
          {"ratio", numberOrNull(row.cost / targeted)},
          {"least", numberOrNull(row.least)},
          {"largest", numberOrNull(row.largest)},
          {"peak", numberOrNull(row.peak)},
          {"seeds", row.seeds},
          {"not_exciting", row.failed}};
}

std::string table(const std::vector<BaselineCost>& rows) {
  std::string text = fmt::format("{:<14}{:>12}{:>9}{:>12}{:>12}{:>12}  {}\n", "signal", "cost",
                                 "ratio", "least", "largest", "peak", "");
  for (const BaselineCost& row : rows) {
    text +=
        fmt::format("{:<14}{:>12.5g}{:>9.3f}{:>12.5g}{:>12.5g}{:>12.5g}  {}\n", row.name, row.cost,
                    row.cost / rows.front().cost, row.least, row.largest, row.peak, row.note);
  }
  return text;
}

}  // namespace

int runBaselines(const BaselinesSettings& settings) {
  const ExplorationProblem problem =
      problemFromJson(quad_support::readFile(settings.problem), settings.problem);
  BaselineOptions options = settings.options;
  if (!settings.band.empty()) {
    options.band_low = settings.band.front();
    options.band_high = settings.band.back();
  }
  DesignOptions design_options;
  design_options.seed = options.seed;
  const DesignResult design =
      withName(settings.problem, [&] { return designExploration(problem, design_options); });
  if (!design.feasible()) {
    std::fprintf(stderr, "explore_opt: %s: %s: %s\n", settings.problem.c_str(),
                 toString(design.status).c_str(), design.message.c_str());
    return quad_support::kNegativeAnswer;
  }
  const auto rows = withName(settings.problem,
                             [&] { return compareBaselines(problem, design.amplitudes, options); });
  ordered_json out = {{"gamma_e", design.gamma_e},
                      {"lower_bound", design.lower_bound},
                      {"gap", design.gap},
                      {"signals", ordered_json::array()}};
  for (const BaselineCost& row : rows) out["signals"].push_back(toJson(row, rows.front().cost));
  writeAnswer(settings.out, prettyJson(out));
  std::fputs(table(rows).c_str(), settings.out.empty() ? stderr : stdout);
  return quad_support::kDone;
}

}  // namespace explore_opt
