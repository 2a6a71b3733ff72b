#include "explore_opt/discretisation.hpp"

#include <unsupported/Eigen/MatrixFunctions>

#include "checks.hpp"

namespace explore_opt {

LinearSystem discretise(const LinearSystem& continuous, double sampling_period) {
  const Eigen::Index nx = continuous.A.rows(), nu = continuous.B.cols();
  require(nx >= 1, "A is empty");
  requireShape(continuous.A, nx, nx, "A");
  requireShape(continuous.B, nx, nu, "B");
  const Eigen::VectorXd W = continuous.W.size() == 0 ? Eigen::VectorXd::Zero(nx) : continuous.W;
  requireShape(W, nx, 1, "W");
  requireFinite(continuous.A, "A");
  requireFinite(continuous.B, "B");
  requireFinite(W, "W");
  requirePositive(sampling_period, "sampling period");

  // Thesis section 2.3: exp([[A, B], [0, 0]] dT) holds A and B of the sampled system; W is one more
  // input.
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(nx + nu + 1, nx + nu + 1);
  generator.topRows(nx) << continuous.A, continuous.B, W;
  const Eigen::MatrixXd transition = (generator * sampling_period).exp();
  return {transition.topLeftCorner(nx, nx), transition.block(0, nx, nx, nu),
          transition.topRightCorner(nx, 1)};
}

}  // namespace explore_opt
