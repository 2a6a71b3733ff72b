/// What a batch flies: an experiment's settings, and how some of them vary from run to run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quad_experiment/experiment_config.hpp"
#include "quad_support/config_reader.hpp"

namespace quad_experiment {

/// How one key varies. docs/batch.md explains each kind with an example.
struct Variation {
  enum class Kind { kGrid, kChoice, kUniform, kLogUniform, kNormal, kInteger, kCount };
  std::string key;  ///< of the settings, e.g. "vehicle.mass", "control.altitude[0]"
  Kind kind = Kind::kGrid;
  std::vector<std::string> values;  ///< grid, choice: as YAML
  double a = 0.0, b = 0.0;      ///< ends of an interval; mean and standard deviation; first number
  double min = 0.0, max = 0.0;  ///< normal: draws outside are drawn again
  bool common = false;          ///< the same draw at every point of the grid
};

/// Run r flies point r mod P of the grid (of P points; the last key changes fastest) and is its
/// repeat r div P, so a study with more repeats begins with the runs of a shorter one.
struct BatchSpec {
  std::string path, base_path;  ///< of the file and of the settings it starts from
  std::string base_text;
  std::uint64_t seed = 0;                   ///< of all draws
  std::int64_t repeats = 0;                 ///< runs of each point of the grid
  std::int64_t points = 1;                  ///< P
  std::vector<quad_support::Override> set;  ///< values other than the base's, for every run
  std::vector<Variation> vary;
  std::string hash;  ///< SHA-256 of everything a row depends on, the program's version included

  std::int64_t runs() const { return repeats * points; }
  /// The varied keys and their values in a run; numbers in shortest form.
  std::vector<quad_support::Override> variedSettings(std::int64_t run) const;
  /// All settings of a run. @throws quad_support::ConfigError if the draw is not a valid experiment
  ExperimentConfig experiment(std::int64_t run) const;
};

/// Reads and checks a spec, and that its first run is a valid experiment.
/// @param repeats  > 0: in place of the file's `runs`
/// @throws quad_support::ConfigError naming file, line, key, value and limit
BatchSpec readBatchSpec(const std::string& path, std::int64_t repeats = 0);

}  // namespace quad_experiment
