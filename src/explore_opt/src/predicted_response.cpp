#include "explore_opt/predicted_response.hpp"

#include "checks.hpp"
#include "constants.hpp"
#include "constraint_shape.hpp"
#include "quad_support/linear_algebra.hpp"
#include "response_root.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Regressors of u = K x + signal from x_0, n_φ x T.
MatrixXd simulate(const ExplorationProblem& problem, const MatrixXd& signal, VectorXd x) {
  const Index nx = problem.numStates();
  MatrixXd phi(problem.numRegressors(), signal.cols());
  for (Index k = 0; k < signal.cols(); ++k) {
    VectorXd u = signal.col(k);
    if (problem.K.size() > 0) u += problem.K * x;
    phi.col(k).head(nx) = x;
    phi.col(k).tail(problem.numInputs()) = u;
    x = problem.A * x + problem.B * u;
  }
  return phi;
}

}  // namespace

MatrixXd PredictedResponse::factor(const VectorXd& a) const {
  MatrixXd sum =
      homogeneous() ? MatrixXd::Zero(factors.front().rows(), factors.front().cols()) : offset;
  for (int i = 0; i < numAmplitudes(); ++i) sum += a(i) * factors[static_cast<std::size_t>(i)];
  return sum;
}

MatrixXd PredictedResponse::information(const VectorXd& a) const {
  const MatrixXd F = factor(a);
  return F.transpose() * F;
}

double PredictedResponse::lambdaMin(const VectorXd& a) const {
  const MatrixXd F = factor(a);
  if (F.rows() < F.cols()) return 0.0;
  const double sigma = quad_support::singularValues(F).tail(1)(0);
  return sigma * sigma;
}

MatrixXd unitResponse(const ExplorationProblem& problem, int component) {
  validate(problem);
  require(component >= 0 && component < problem.numAmplitudes(), "component {}; must lie in 0..{}",
          component, problem.numAmplitudes() - 1);
  const MatrixXd signals = carriers(problem.lines, problem.phase);
  MatrixXd signal = MatrixXd::Zero(problem.numInputs(), signals.cols());
  signal.row(component % problem.numInputs()) = signals.row(component / problem.numInputs());
  return simulate(problem, signal, VectorXd::Zero(problem.numStates()));
}

MatrixXd predictedInputs(const ExplorationProblem& problem, const MatrixXd& amplitudes) {
  const MatrixXd signal = multisine(problem.lines, problem.phase, amplitudes);
  const VectorXd x0 =
      problem.x0.size() > 0 ? problem.x0 : VectorXd(VectorXd::Zero(problem.numStates()));
  return simulate(problem, signal, x0).bottomRows(problem.numInputs());
}

MatrixXd closenessInverseRoot(const ExplorationProblem& problem) {
  return ConstraintShape(problem).root();
}

PredictedResponse predictResponse(const ExplorationProblem& problem) {
  validate(problem);
  const ResponseRoot root = responseRoot(problem);
  const ConstraintShape shape(problem);
  PredictedResponse response;
  for (const MatrixXd& block : root.blocks) response.factors.push_back(shape.factor(block));
  if (static_cast<int>(root.blocks.size()) > problem.numAmplitudes()) {
    response.offset = response.factors.back();
    response.factors.pop_back();
  }
  return response;
}

}  // namespace explore_opt
