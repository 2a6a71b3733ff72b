/// Amplitudes as they stand in JSON: rows, with both phases {"cos": rows, "sin": rows}, with
/// several experiments a list of either.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explore_opt/exploration_signal.hpp"

namespace explore_opt {

/// @returns carriers x n_u, cosines above sines, several experiments one below the other
/// @throws quad_support::ConfigError: wrong types, tables that differ in shape
Eigen::MatrixXd amplitudeTables(const nlohmann::json& value, Phase phase,
                                const std::string& source);

/// The tables of a design's answer: its `amplitudes`, or `experiments` where there are several.
/// @throws quad_support::ConfigError also where none or both of them are there
Eigen::MatrixXd answeredAmplitudes(const nlohmann::json& answer, Phase phase,
                                   const std::string& source);

}  // namespace explore_opt
