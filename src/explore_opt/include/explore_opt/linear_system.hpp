/// Exact sampling of a continuous-time linear system with inputs held constant over the sampling
/// period.
#pragma once

#include <Eigen/Core>

namespace explore_opt {

/// A linear system with a constant disturbance, x⁺ = A x + B u + W (discrete) or ẋ = A x + B u + W
/// (continuous).
struct LinearSystem {
  Eigen::MatrixXd A;  ///< n_x x n_x
  Eigen::MatrixXd B;  ///< n_x x n_u
  Eigen::VectorXd W;  ///< n_x; zero if there is no constant disturbance
};

/// Zero-order hold by the matrix exponential of [[A, B, W], [0, 0, 0]] dT, thesis section 2.3.
/// @param continuous       ẋ = A x + B u + W; an empty W means none
/// @param sampling_period  dT > 0 [s]
/// @throws quad_support::DataError: shapes that do not fit, a value that is not finite, dT not
/// positive
LinearSystem discretise(const LinearSystem& continuous, double sampling_period);

}  // namespace explore_opt
