#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "commands.hpp"
#include "explore_opt/design_dump.hpp"
#include "explore_opt/design_json.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

const char* const kDesignHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt design problem.json --out design.json
  explore_opt design problem.json --method mm --initial design.json --cost-tolerance 1e-6
D_des: a number (times I), n_phi x n_phi (meaning D (x) I) or the full matrix; may be singular. Optional: x0 (start),
K (u = K x + signal) and cost (signal | input), known ([A B] with null where unknown), u_max (a number or one an input),
experiments (runs with amplitudes of their own). The answer's amplitudes: a row a carrier, a column an input; phase both: {"cos": rows, "sin": rows}. --initial takes the
same rows or a whole answer; only their direction counts, the size is scaled to the boundary.
Exit code 0: amplitudes found; 3: there are none, or they are not trustworthy (see "status"); 2: bad input;
5: the answer cannot be written.)";

namespace {

/// Options of one method that were set for the other.
void refuseIdleOptions(const DesignSettings& settings, DesignMethod method) {
  const DesignOptions &o = settings.options, usual;
  const bool mm = method == DesignMethod::kMm;
  const std::vector<std::pair<const char*, bool>> idle = {
      {"--initial", !mm && !settings.initial.empty()},
      {"--plain", !mm && settings.plain},
      {"--max-iterations", !mm && o.max_iterations != usual.max_iterations},
      {"--cost-tolerance", !mm && o.cost_tolerance != usual.cost_tolerance},
      {"--step-tolerance", !mm && o.step_tolerance != usual.step_tolerance},
      {"--starts", mm && o.random_starts != usual.random_starts}};
  for (const auto& [option, set] : idle) {
    if (!set) continue;
    throw quad_support::DataError(fmt::format("{} has no effect on method {}; {}", option,
                                              toString(method),
                                              mm ? "leave it out" : "add --method mm"));
  }
}

}  // namespace

int runDesign(const DesignSettings& settings) {
  const std::string text = quad_support::readFile(settings.problem);
  const ExplorationProblem problem = problemFromJson(text, settings.problem);
  DesignOptions options = settings.options;
  options.method = methodFromString(settings.method);
  options.extrapolate = !settings.plain;
  refuseIdleOptions(settings, options.method);
  if (!settings.initial.empty()) {
    options.initial_amplitudes =
        amplitudesFromJson(quad_support::readFile(settings.initial), settings.initial, problem)
            .reshaped<Eigen::RowMajor>();
  }
  const DesignResult result =
      withName(settings.problem, [&] { return designExploration(problem, options); });
  writeAnswer(settings.out, prettyJson(designToJson(problem, result)));
  if (!settings.dump.empty()) writeAnswer(settings.dump, dumpDesign(text, options, result));
  if (result.status == DesignStatus::kSolved || result.status == DesignStatus::kReducedAccuracy) {
    return quad_support::kDone;
  }
  std::fprintf(stderr, "explore_opt: %s: %s: %s\n", settings.problem.c_str(),
               toString(result.status).c_str(), result.message.c_str());
  return quad_support::kNegativeAnswer;
}

}  // namespace explore_opt
