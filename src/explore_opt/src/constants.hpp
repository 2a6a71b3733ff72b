/// Numbers and short names that several sources share.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "quad_support/constants.hpp"

namespace explore_opt {

using Eigen::Index;

using quad_support::kPi;
constexpr double kTwoPi = 2.0 * kPi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Of a regressor whose rows are scaled to length one. Above it, least squares answers "too little
/// excitation": half of a double's sixteen digits would be gone from S = Phi Phi'.
constexpr double kLargestCondition = 1e10;

}  // namespace explore_opt
