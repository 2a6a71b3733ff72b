#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "explore_opt/design_dump.hpp"
#include "explore_opt/design_json.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

const char* const kReplayHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt design problem.json --out design.json --dump dump.json
  explore_opt replay dump.json --out again.json
Solves the problem of a dump again, with its options, and writes the new answer.
Exit code 0: the same status and gamma_e (to 1e-9); 3: another answer; 2: bad input.)";

int runReplay(const ReplaySettings& settings) {
  const Replay replay = replayDesign(quad_support::readFile(settings.dump), settings.dump);
  writeAnswer(settings.out, prettyJson(designToJson(replay.problem, replay.result)));
  if (replay.agrees()) return quad_support::kDone;
  std::fprintf(stderr, "explore_opt: %s: recorded %s, gamma_e %.17g; now %s, gamma_e %.17g\n",
               settings.dump.c_str(), replay.recorded_status.c_str(), replay.recorded_gamma_e,
               toString(replay.result.status).c_str(), replay.result.gamma_e);
  return quad_support::kNegativeAnswer;
}

}  // namespace explore_opt
