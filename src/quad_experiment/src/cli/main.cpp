#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "quad_experiment/version.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

int main(int argc, char** argv) {
  CLI::App app("Flies targeted-exploration experiments in one process, without ROS, and says whether the promise was kept.");
  app.footer("Example:\n  quad_experiment run --config config/thesis.yaml --out results/in_process\n"
             "The same experiment over ROS: scripts/experiment --config config/thesis.yaml --out results/ros");
  app.set_version_flag("--version", quad_experiment::kVersion);
  app.require_subcommand(1);
  Command chosen;
  addRunCommand(app, chosen);
  addCheckCommand(app, chosen);
  addPercentilesCommand(app, chosen);
  addStepCommand(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? quad_support::kDone : quad_support::kBadInput;
  }
  return quad_support::runProgram("quad_experiment", chosen);
}
