/// Problems and designs as JSON text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explore_opt/exploration_design.hpp"

namespace explore_opt {

/// Reads a problem: keys A, B, T, harmonics or frequencies, phase, gamma_w, D_des, and optionally
/// x0, K, cost ("signal", "input"), known ([A B] with null where unknown), u_max (a number, or one
/// for each input), experiments. See ExplorationProblem.
/// @param source  name for messages, a path say
/// @throws quad_support::ConfigError: text that is not JSON, missing, unknown or repeated keys,
/// wrong types or values
ExplorationProblem problemFromJson(const std::string& text, const std::string& source);

/// The answer with keys status, method, amplitudes ([[α_1 of n_u], ...] or {"cos", "sin"}),
/// gamma_e, lower_bound, gap, certificate, lambda_min, iterations ({gamma_e, step, inner_gap,
/// amplitudes}), inner_gap, seconds, message, multiplier, multiplier_root, relaxation_rank; with
/// u_max also peak_multipliers ({sample, input or null, value}) and peak; with several experiments
/// amplitudes is null and `experiments` lists those of each run. A value that does not exist is
/// null. Doubles are printed so that they read back the same.
nlohmann::ordered_json designToJson(const ExplorationProblem& problem, const DesignResult& result);

/// Amplitudes in the shape designToJson() writes them, or a whole answer with them under
/// `amplitudes`.
/// @returns carriers x n_u, several experiments one below the other
/// @throws quad_support::ConfigError: text that is not JSON, wrong types, shape or values
Eigen::MatrixXd amplitudesFromJson(const std::string& text, const std::string& source,
                                   const ExplorationProblem& problem);

/// Indented text with a list of numbers on one line, ending in a newline.
std::string prettyJson(const nlohmann::ordered_json& value);

}  // namespace explore_opt
