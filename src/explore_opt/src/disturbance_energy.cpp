#include "explore_opt/disturbance_energy.hpp"

#include "checks.hpp"

namespace explore_opt {
namespace {

/// The system's W, zero where it has none, after checking all shapes against the trajectory.
Eigen::VectorXd offsetFor(const LinearSystem& system, const Eigen::MatrixXd& X,
                          const Eigen::MatrixXd& U) {
  requireTrajectory(X, U);
  requireShape(system.A, X.rows(), X.rows(), "A");
  requireShape(system.B, X.rows(), U.rows(), "B");
  if (system.W.size() == 0) return Eigen::VectorXd::Zero(X.rows());
  requireShape(system.W, X.rows(), 1, "W");
  return system.W;
}

}  // namespace

double constantDisturbanceEnergy(const Eigen::VectorXd& W, int num_samples) {
  require(num_samples >= 1, "T = {}; must be at least 1", num_samples);
  requireFinite(W, "W");
  return num_samples * W.squaredNorm();
}

Eigen::VectorXd compensatedDisturbance(const LinearSystem& system,
                                       const Eigen::VectorXd& feedforward) {
  requireShape(feedforward, system.B.cols(), 1, "feed-forward");
  requireShape(system.W, system.B.rows(), 1, "W");
  return system.B * feedforward + system.W;
}

double oneStepEnergy(const LinearSystem& system, const Eigen::MatrixXd& X,
                     const Eigen::MatrixXd& U) {
  const Eigen::VectorXd W = offsetFor(system, X, U);
  const Eigen::Index T = U.cols();
  const Eigen::MatrixXd predicted = (system.A * X.leftCols(T) + system.B * U).colwise() + W;
  return (X.rightCols(T) - predicted).squaredNorm();
}

double simulationEnergy(const LinearSystem& system, const Eigen::MatrixXd& X,
                        const Eigen::MatrixXd& U) {
  const Eigen::VectorXd W = offsetFor(system, X, U);
  double energy = 0.0;
  Eigen::VectorXd simulated = X.col(0);
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    simulated = system.A * simulated + system.B * U.col(k) + W;
    energy += (X.col(k + 1) - simulated).squaredNorm();
  }
  return energy;
}

}  // namespace explore_opt
