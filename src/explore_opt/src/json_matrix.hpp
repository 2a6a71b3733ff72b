/// Matrices in JSON: lists of rows of numbers.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>

namespace explore_opt {

/// @throws quad_support::ConfigError naming source: not JSON (with the position), a key given twice
/// in an object
nlohmann::json parseJson(const std::string& text, const std::string& source);

/// @param name  source and key, for messages   @throws quad_support::ConfigError: not a list of
/// rows of equal length
Eigen::MatrixXd matrixFromJson(const nlohmann::json& rows, const std::string& name);

nlohmann::ordered_json matrixToJson(const Eigen::MatrixXd& m);

}  // namespace explore_opt
