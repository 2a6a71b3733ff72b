#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

// The only file that includes CLI11: it takes long to compile.
namespace {

struct Options {
  RunOptions run;
  CheckOptions check;
  PercentilesOptions percentiles;
  StepOptions step;
  CompareOptions compare;
  BatchCommandOptions batch;
  BatchReplayOptions replay;
  ExportOptions exported;
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

void addCompare(CLI::App& app, CompareOptions& o, std::function<int()>& chosen) {
  auto* command = app.add_subcommand(
      "compare", "Fly the targeted signal and the textbook's at equal energy, and rank them");
  command->add_option("--config", o.config, "experiment settings (YAML)")->required();
  command->add_option("--out", o.out, "directory for comparison.json and .csv; must not exist")
      ->required();
  command->add_option("--seeds", o.seeds, "flights of each signal")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command->add_flag("--force", o.force, "replace an existing results directory");
  command->footer(
      "Example:\n  quad_experiment compare --config config/thesis.yaml --out results/compare");
  command->callback([&] { chosen = [&o] { return compare(o); }; });
}

void addBatchParts(CLI::App& command, Options& all, std::function<int()>& chosen) {
  BatchCommandOptions& o = all.batch;
  auto* describe =
      command.add_subcommand("describe", "Print runs, columns and hash of a spec as JSON");
  describe->add_option("--spec", o.spec, "what varies (YAML)")->required();
  describe->add_option("--runs", o.runs, "in place of the spec's `runs`")
      ->check(CLI::Range(1, 1000000000));
  describe->footer("Example:\n  quad_experiment batch describe --spec config/monte_carlo.yaml");
  describe->callback([&] { chosen = [&o] { return batchDescribe(o); }; });

  auto* worker = command.add_subcommand("worker", "")->group("");  // started by the pool only
  worker->add_option("--spec", o.spec)->required();
  worker->add_option("--out", o.out)->required();
  worker->add_option("--runs", o.runs)->required();
  worker->add_option("--hash", o.hash)->required();
  worker->callback([&] { chosen = [&o] { return batchWorker(o); }; });

  BatchReplayOptions& r = all.replay;
  auto* replay =
      command.add_subcommand("replay", "Fly one run of a batch again, with everything it leaves");
  replay->add_option("run", r.run, "number of the run")->required();
  replay->add_option("--batch", r.batch, "directory of the batch; its row must come out the same");
  replay->add_option("--spec", r.spec, "the spec alone, without comparing");
  replay->add_option("--out", r.out, "directory for the results; must not exist")->required();
  replay->add_flag("--force", r.force, "replace an existing results directory");
  replay->footer(
      "Example:\n  quad_experiment batch replay 17 --spec config/monte_carlo.yaml --out "
      "results/run_17");
  replay->callback([&] { chosen = [&r] { return batchReplay(r); }; });
}

void addBatch(CLI::App& app, Options& all, std::function<int()>& chosen) {
  BatchCommandOptions& o = all.batch;
  auto* command = app.add_subcommand(
      "batch",
      "Fly many experiments on all cores: Monte Carlo and parameter sweeps (docs/batch.md)");
  command->add_option("--spec", o.spec, "what varies (YAML), see config/monte_carlo.yaml");
  command->add_option("--out", o.out, "directory for results.csv; must not exist");
  command
      ->add_option("--runs", o.runs,
                   "in place of the spec's `runs`: repeats of each point of the grid")
      ->check(CLI::Range(1, 1000000000));
  command->add_option("--workers", o.workers, "processes; 0: one a core")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  command
      ->add_option("--chunk", o.chunk, "runs written at a time; 0: so many that it takes seconds")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  command->add_option("--timeout", o.timeout, "[s] processor time after which a run is given up")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e6));
  command->add_option("--shard", o.shard,
                      "i/n: fly the i-th of n parts; all fill the same directory");
  command->add_flag("--resume", o.resume, "fly what is missing in an existing directory");
  command->add_flag("--force", o.force, "begin again in an existing directory of a batch");
  command->require_subcommand(0, 1);
  command->footer(
      "Example:\n  quad_experiment batch --spec config/monte_carlo.yaml --out results/monte_carlo\n"
      "Exit code: 0 every run has its row, 2 bad input, 5 environment, 130/143 interrupted "
      "(--resume goes on).");
  addBatchParts(*command, all, chosen);
  command->callback([&, command] {
    if (command->get_subcommands().empty()) chosen = [&o] { return batch(o); };
  });
}

void addExport(CLI::App& app, ExportOptions& o, std::function<int()>& chosen) {
  auto* command = app.add_subcommand(
      "export", "Write a finished run for ROS tools, MATLAB, pandas or PlotJuggler (needs Python)");
  command->add_option("results", o.results, "directory of a finished run")->required();
  command->add_option("--out", o.out, "directory for the files; default: export/ in the results");
  command->add_flag("--bag", o.bag, "a ROS 1 bag a flight, for rosbag, rqt and replay_bag");
  command->add_flag("--mat", o.mat,
                    "a .mat a flight: y, u, Ts, names and units, as iddata takes them");
  command->add_flag("--parquet", o.parquet, "all flights in one table, for pandas");
  command->add_flag("--plotjuggler", o.plotjuggler, "CSV files and a layout that loads them");
  command->footer(
      "Example:\n  quad_experiment export results/thesis --bag --mat\n"
      "Exit code: 0 done, 2 not a finished run, 5 a Python package or the disk is missing.");
  command->callback([&] { chosen = [&o] { return exportRun(o); }; });
}

std::vector<std::string> namesOf(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

int parseAndRun(int argc, char** argv) {
  CLI::App app(
      "Flies targeted-exploration experiments in one process, without ROS, and says whether the "
      "promise was kept.");
  app.footer(
      "Example:\n  quad_experiment run --config config/thesis.yaml --out results/in_process\n"
      "The same experiment over ROS: scripts/experiment --config config/thesis.yaml --out "
      "results/ros");
  app.set_version_flag("--version", quad_support::kVersion);
  app.require_subcommand(1);
  Options options;
  std::function<int()> chosen;
  addRun(app, options.run, chosen);
  addCheck(app, options.check, chosen);
  addPercentiles(app, options.percentiles, chosen);
  addStep(app, options.step, chosen);
  addCompare(app, options.compare, chosen);
  addBatch(app, options, chosen);
  addExport(app, options.exported, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    const CLI::App& all = app;
    throw quad_support::ConfigError(quad_support::argumentProblem(
        "quad_experiment", e.what(), namesOf(all.get_subcommands({})), argc, argv));
  }
  return chosen();
}

}  // namespace

int main(int argc, char** argv) {
  return quad_support::runProgram("quad_experiment", [&] { return parseAndRun(argc, argv); });
}
