/// A solve in one file: problem, options and answer, so that it can be repeated elsewhere.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explore_opt/exploration_design.hpp"

namespace explore_opt {

/// {"problem": ..., "options": ..., "answer": ...} as text.
/// @param problem_text  the problem as JSON, kept as it stands
std::string dumpDesign(const std::string& problem_text, const DesignOptions& options,
                       const DesignResult& result);

/// What a repeated solve found.
struct Replay {
  DesignResult result;
  ExplorationProblem problem;
  std::string recorded_status;
  double recorded_gamma_e = 0.0;  ///< NaN if there was none
  /// The same status, and γ_e to 1e-9 (another machine or compiler rounds otherwise)
  bool agrees() const;
};

/// Solves the problem of a dump again with its options.
/// @throws quad_support::ConfigError: not a dump; DataError as designExploration()
Replay replayDesign(const std::string& dump_text, const std::string& source);

}  // namespace explore_opt
