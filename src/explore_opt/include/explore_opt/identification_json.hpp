/// What identification reads from JSON text.
#pragma once

#include <Eigen/Core>
#include <string>

namespace explore_opt {

// `source` names the text in messages. @throws quad_support::ConfigError: text that is not JSON,
// wrong types or shapes

/// D_des: a number (1 x 1) or a matrix.
Eigen::MatrixXd closenessFromJson(const std::string& text, const std::string& source);

/// [A B] with null where an entry is not known; NaN there.
Eigen::MatrixXd knownFromJson(const std::string& text, const std::string& source);

/// [A B], or an answer of identify with it under `Theta`.
Eigen::MatrixXd thetaFromJson(const std::string& text, const std::string& source);

}  // namespace explore_opt
