/// A small smooth program as the solver sees it: min f(x) s.t. c(x) = 0 for the first constraints,
/// c(x) >= 0 for the last ones.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace explore_opt {

/// (row, column) of the entries that may be nonzero
using Positions = std::vector<std::pair<int, int>>;

/// Values are asked for in the order of the positions. `false` from f or its gradient means
/// "outside the domain".
class SmoothProgram {
 public:
  virtual ~SmoothProgram() = default;
  virtual int numVariables() const = 0;
  virtual int numConstraints() const { return 0; }
  virtual int numInequalities() const { return 0; }  ///< the last so many of the constraints
  virtual bool objective(const Eigen::VectorXd& x, double& f) = 0;
  virtual bool gradient(const Eigen::VectorXd& x, Eigen::VectorXd& g) = 0;
  virtual void constraints(const Eigen::VectorXd&, Eigen::VectorXd&) {}
  virtual Positions jacobianPositions() const { return {}; }
  virtual void jacobian(const Eigen::VectorXd&, Eigen::VectorXd&) {}
  virtual Positions hessianPositions() const = 0;  ///< lower triangle
  /// Of weight f + multipliersᵀ c.
  virtual bool hessian(const Eigen::VectorXd& x, double weight, const Eigen::VectorXd& multipliers,
                       Eigen::VectorXd& values) = 0;
};

}  // namespace explore_opt
