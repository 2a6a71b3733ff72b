#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "cli/commands.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Targeted exploration of linear systems under energy-bounded disturbances",
               "explore_opt");
  app.require_subcommand(1);
  app.footer("The --help of each subcommand shows an example that runs.");
  const std::map<std::string, explore_opt::Action> actions = {
      {"frequencies", explore_opt::addFrequenciesCommand(app)},
      {"design", explore_opt::addDesignCommand(app)},
      {"audit", explore_opt::addAuditCommand(app)},
      {"baselines", explore_opt::addBaselinesCommand(app)},
      {"predict", explore_opt::addPredictCommand(app)},
      {"identify", explore_opt::addIdentifyCommand(app)},
      {"replay", explore_opt::addReplayCommand(app)}};
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help
    throw quad_support::DataError(std::string(e.what()) + " (explore_opt --help tells more)");
  }
  return actions.at(app.get_subcommands().front()->get_name())();
}

}  // namespace

int main(int argc, char** argv) {
  return quad_support::runProgram("explore_opt", [argc, argv] { return run(argc, argv); });
}
