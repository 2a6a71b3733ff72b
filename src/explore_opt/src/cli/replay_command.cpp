#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "explore_opt/design_dump.hpp"
#include "explore_opt/design_json.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

constexpr const char* kHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt design problem.json --out design.json --dump dump.json
  explore_opt replay dump.json --out again.json
Solves the problem of a dump again, with its options, and writes the new answer.
Exit code 0: the same status and gamma_e (to 1e-9); 3: another answer; 2: bad input.)";

struct Settings {
  std::string dump, out;
};

int replayOnce(const Settings& settings) {
  const Replay replay = replayDesign(quad_support::readFile(settings.dump), settings.dump);
  writeAnswer(settings.out, prettyJson(designToJson(replay.problem, replay.result)));
  if (replay.agrees()) return quad_support::kDone;
  std::fprintf(stderr, "explore_opt: %s: recorded %s, gamma_e %.17g; now %s, gamma_e %.17g\n",
               settings.dump.c_str(), replay.recorded_status.c_str(), replay.recorded_gamma_e,
               toString(replay.result.status).c_str(), replay.result.gamma_e);
  return quad_support::kNegativeAnswer;
}

}  // namespace

Action addReplayCommand(CLI::App& app) {
  const auto settings = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand("replay", "Repeats a solve from its dump and compares");
  command->footer(kHelp);
  command->add_option("dump", settings->dump, "File of design --dump")->required();
  command->add_option("--out", settings->out, "File for the answer; default: standard output");
  return [settings] { return replayOnce(*settings); };
}

}  // namespace explore_opt
