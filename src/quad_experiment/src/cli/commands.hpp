/// The subcommands of the program quad_experiment, each with what it is told.
#pragma once

#include <string>

struct RunOptions {
  std::string config, out;
  bool force = false;
};
struct CheckOptions {
  std::string config;
  std::string mode;  ///< "" as in the configuration
};
struct PercentilesOptions {
  std::string results;
  int seeds = 200;
  int workers = 0;  ///< 0: one a core
};
struct StepOptions {
  std::string config, out;
  double height = 1.0;     ///< [m]
  double duration = 20.0;  ///< [s]
  bool force = false;
};
struct CompareOptions {
  std::string config, out;
  int seeds = 20;
  bool force = false;
};
struct BatchCommandOptions {
  std::string spec, out;
  long long runs = 0;      ///< repeats of each point of the grid; 0: as the spec says
  int workers = 0;         ///< 0: one a core
  long long chunk = 0;     ///< runs a chunk; 0: seconds
  double timeout = 300.0;  ///< [s]
  std::string shard;       ///< "i/n"
  bool resume = false, force = false;
  std::string hash;  ///< of a worker
};
struct BatchReplayOptions {
  long long run = 0;
  std::string spec, batch, out;
  bool force = false;
};
struct ExportOptions {
  std::string results;
  std::string out;  ///< "": export/ in the results directory
  bool bag = false, mat = false, parquet = false, plotjuggler = false;
};

namespace quad_experiment {
struct ExperimentConfig;
}
/// Says on stderr what is flown a little differently than it is written.
void tellNotes(const quad_experiment::ExperimentConfig& config);

/// Shows `text` and where the results are. @throws quad_support::EnvironmentError if stdout cannot
/// be written
void tellResults(const std::string& text, const std::string& results);

// All return an exit code and throw what quad_support::runProgram() understands.
int run(const RunOptions& options);
int check(const CheckOptions& options);
int percentiles(const PercentilesOptions& options);
int compare(const CompareOptions& options);
int batch(const BatchCommandOptions& options);
int batchDescribe(const BatchCommandOptions& options);
int batchWorker(const BatchCommandOptions& options);
int batchReplay(const BatchReplayOptions& options);
int step(const StepOptions& options);
int exportRun(const ExportOptions& options);
