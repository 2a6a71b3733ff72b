/// A linear system with a constant disturbance.
#pragma once

#include <Eigen/Core>

namespace explore_opt {

/// x⁺ = A x + B u + W.
struct LinearSystem {
  Eigen::MatrixXd A;  ///< n_x x n_x
  Eigen::MatrixXd B;  ///< n_x x n_u
  Eigen::VectorXd W;  ///< n_x; zero if there is no constant disturbance
};

}  // namespace explore_opt
