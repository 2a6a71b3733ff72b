#include <CLI/CLI.hpp>
#include <functional>

#include "commands.hpp"
#include "quad_experiment/version.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

// The only file that includes CLI11: it takes long to compile.
namespace {

struct Options {
  RunOptions run;
  CheckOptions check;
  PercentilesOptions percentiles;
  StepOptions step;
};

void addRun(CLI::App& app, RunOptions& o, std::function<int()>& chosen) {
  auto* command =
      app.add_subcommand("run", "Design, fly, identify and judge one experiment in this process");
  command->add_option("--config", o.config, "experiment settings (YAML), see config/thesis.yaml")
      ->required();
  command->add_option("--out", o.out, "directory for the results; must not exist")->required();
  command->add_flag("--force", o.force, "replace an existing results directory");
  command->footer(
      "Example:\n  quad_experiment run --config config/exact.yaml --out results/exact\n"
      "Exit code: 0 promise kept, 2 bad input, 3 promise broken, 4 simulation failed, 5 "
      "environment.");
  command->callback([&] { chosen = [&o] { return run(o); }; });
}

void addCheck(CLI::App& app, CheckOptions& o, std::function<int()>& chosen) {
  auto* command = app.add_subcommand("check", "Read and check settings and vehicle; fly nothing");
  command->add_option("--config", o.config, "experiment settings (YAML)")->required();
  command->add_option("--mode", o.mode, "timing mode it will be flown in")
      ->check(CLI::IsMember({"lockstep", "wallclock"}));
  command->footer(
      "Example:\n  quad_experiment check --config config/thesis.yaml\nExit code: 0 good, 2 bad "
      "input.");
  command->callback([&] { chosen = [&o] { return check(o); }; });
}

void addPercentiles(CLI::App& app, PercentilesOptions& o, std::function<int()>& chosen) {
  auto* command = app.add_subcommand(
      "percentiles", "Show where a finished run lies among many seeds of the same experiment");
  command
      ->add_option("--results", o.results,
                   "directory of a finished run; percentiles.json is added to it")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--seeds", o.seeds, "number of seeds")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  command->add_option("--workers", o.workers, "threads; 0: one a core")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  command->footer("Example:\n  quad_experiment percentiles --results results/thesis --seeds 200");
  command->callback([&] { chosen = [&o] { return percentiles(o); }; });
}

void addStep(CLI::App& app, StepOptions& o, std::function<int()>& chosen) {
  auto* command = app.add_subcommand(
      "step", "Fly a step of the reference altitude under PI control (thesis Figs 2.2, 2.3)");
  command->add_option("--config", o.config, "experiment settings (YAML)")->required();
  command->add_option("--out", o.out, "directory for trajectory.csv; must not exist")->required();
  command->add_option("--height", o.height, "[m] step of the reference")->capture_default_str();
  command->add_option("--duration", o.duration, "[s] length of the flight")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 600.0));
  command->add_flag("--force", o.force, "replace an existing results directory");
  command->footer(
      "Example:\n  quad_experiment step --config config/exact.yaml --out results/step --height 1");
  command->callback([&] { chosen = [&o] { return step(o); }; });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Flies targeted-exploration experiments in one process, without ROS, and says whether the "
      "promise was kept.");
  app.footer(
      "Example:\n  quad_experiment run --config config/thesis.yaml --out results/in_process\n"
      "The same experiment over ROS: scripts/experiment --config config/thesis.yaml --out "
      "results/ros");
  app.set_version_flag("--version", quad_experiment::kVersion);
  app.require_subcommand(1);
  Options options;
  std::function<int()> chosen;
  addRun(app, options.run, chosen);
  addCheck(app, options.check, chosen);
  addPercentiles(app, options.percentiles, chosen);
  addStep(app, options.step, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? quad_support::kDone : quad_support::kBadInput;
  }
  return quad_support::runProgram("quad_experiment", chosen);
}
