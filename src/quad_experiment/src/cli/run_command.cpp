#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace {

using namespace quad_experiment;

struct Options {
  std::string config, out;
  bool force = false;
};

/// One line on stderr that is written over, at most ten times a second of simulated time; quiet when not a terminal.
class ProgressLine {
 public:
  void operator()(const ExperimentStatus& s) {
    if (!terminal_) return;
    if (s.phase == "done") {
      std::fprintf(stderr, "\r\033[K");
    } else if (s.flight.empty()) {
      std::fprintf(stderr, "\r%s …", s.phase.c_str());
    } else if (++count_ % 50 == 0) {
      std::fprintf(stderr, "\r\033[K%s flight: %s, %.1f of %.1f s", s.flight.c_str(), s.phase.c_str(), s.time, s.duration);
    }
  }

 private:
  bool terminal_ = ::isatty(STDERR_FILENO) != 0;
  int count_ = 0;
};

int run(const Options& options) {
  const ExperimentConfig config = readExperimentConfig(options.config);
  if (config.timing.mode == quad_control::TimingMode::kWallclock) {
    throw quad_support::ConfigError(options.config +
                                    ": timing.mode = wallclock; wall-clock time exists over ROS only: use scripts/experiment "
                                    "--config " + options.config + ", or set lockstep");
  }
  quad_support::ResultDirectory results(options.out, options.force);
  InProcessPlant plant(config.simulation, config.control);
  try {
    const ExperimentResult result = runExperiment(config, plant, "in_process", results, ProgressLine());
    std::fputs(quad_support::readFile(results.workPath() + "/table.txt").c_str(), stdout);
    results.commit();
    std::printf("results: %s\n", results.path().c_str());
    return result.exitCode();
  } catch (const NoDesign& e) {
    std::fprintf(stderr, "quad_experiment: %s\n", e.what());
    return quad_support::kNegativeAnswer;
  }
}

}  // namespace

void addRunCommand(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("run", "Design, fly, identify and judge one experiment in this process");
  command->add_option("--config", options->config, "experiment settings (YAML), see config/thesis.yaml")->required();
  command->add_option("--out", options->out, "directory for the results; must not exist")->required();
  command->add_flag("--force", options->force, "replace an existing results directory");
  command->footer("Example:\n  quad_experiment run --config config/exact.yaml --out results/exact\n"
                  "Exit code: 0 promise kept, 2 bad input, 3 promise broken, 4 simulation failed, 5 environment.");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}
