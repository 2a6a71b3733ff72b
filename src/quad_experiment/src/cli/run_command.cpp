#include <unistd.h>

#include <cstdio>

#include "commands.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

namespace {

using namespace quad_experiment;

/// One line on stderr that is written over, at most ten times a second of simulated time; quiet
/// when not a terminal.
class ProgressLine {
 public:
  void operator()(const ExperimentStatus& s) {
    if (!terminal_) return;
    if (s.phase == "done") {
      std::fprintf(stderr, "\r\033[K");
    } else if (s.flight.empty()) {
      std::fprintf(stderr, "\r%s …", s.phase.c_str());
    } else if (++count_ % 50 == 0) {
      std::fprintf(stderr, "\r\033[K%s flight: %s, %.1f of %.1f s", s.flight.c_str(),
                   s.phase.c_str(), s.time, s.duration);
    }
  }

 private:
  bool terminal_ = ::isatty(STDERR_FILENO) != 0;
  int count_ = 0;
};

}  // namespace

void tellNotes(const ExperimentConfig& config) {
  for (const std::string& note : notes(config))
    std::fprintf(stderr, "quad_experiment: note: %s\n", note.c_str());
}

void tellResults(const std::string& text, const std::string& results) {
  quad_support::print(text + "results: " + results + "\n", "the results stand in " + results);
}

int run(const RunOptions& options) {
  const ExperimentConfig config = readExperimentConfig(options.config);
  if (config.timing.mode == quad_control::TimingMode::kWallclock) {
    throw quad_support::ConfigError(
        options.config +
        ": timing.mode = wallclock; wall-clock time exists over ROS only: use scripts/experiment "
        "--config " +
        options.config + ", or set lockstep");
  }
  tellNotes(config);
  quad_support::ResultDirectory results(options.out, options.force);
  InProcessPlant first(config), second(config);  // a world for each flight
  const ExperimentResult result =
      runExperiment(config, {&first, &second}, "in_process", results, ProgressLine());
  const std::string table = quad_support::readFile(results.workPath() + "/table.txt");
  results.commit();
  tellResults(table, results.path());
  if (!result.ok()) std::fprintf(stderr, "quad_experiment: %s\n", result.problem().c_str());
  return result.exitCode();
}
