#include "explore_opt/predicted_response.hpp"

#include <Eigen/QR>
#include <unsupported/Eigen/KroneckerProduct>

#include "checks.hpp"
#include "explore_opt/set_membership.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool hasFeedback(const ExplorationProblem& problem) { return problem.K.size() > 0; }

/// D_des as n_φ x n_φ where it means D ⊗ I, else in full.
MatrixXd reducedCloseness(const ExplorationProblem& problem) {
  const int n = problem.numRegressors();
  if (problem.D_des.size() == 1) return problem.D_des(0, 0) * MatrixXd::Identity(n, n);
  return problem.D_des;
}

/// Rows x_0 ... x_{T-1} of (A, b) driven by e from rest, T x n_x.
MatrixXd statesFromRest(const MatrixXd& A, const VectorXd& b, const VectorXd& e) {
  MatrixXd states(A.rows(), e.size());
  VectorXd x = VectorXd::Zero(A.rows());
  for (Index k = 0; k < e.size(); ++k) {
    states.col(k) = x;
    x = A * x + b * e(k);
  }
  return states;
}

MatrixXd responseTo(const ExplorationProblem& problem, const VectorXd& carrier, int input) {
  const MatrixXd A = hasFeedback(problem) ? MatrixXd(problem.A + problem.B * problem.K) : problem.A;
  MatrixXd response(problem.numRegressors(), carrier.size());
  response.topRows(problem.numStates()) = statesFromRest(A, problem.B.col(input), carrier);
  auto inputs = response.bottomRows(problem.numInputs());
  inputs.setZero();
  inputs.row(input) = carrier.transpose();
  if (hasFeedback(problem)) inputs += problem.K * response.topRows(problem.numStates());
  return response;
}

/// All responses side by side, T x (p n_φ).
MatrixXd stackedResponses(const ExplorationProblem& problem) {
  const MatrixXd signals = carriers(problem.lines, problem.phase);
  const Index n = problem.numRegressors(), nu = problem.numInputs();
  MatrixXd stacked(signals.cols(), signals.rows() * nu * n);
  for (Index i = 0; i < signals.rows(); ++i) {
    for (int j = 0; j < nu; ++j) {
      stacked.middleCols((i * nu + j) * n, n) =
          responseTo(problem, signals.row(i).transpose(), j).transpose();
    }
  }
  return stacked;
}

/// Upper triangle of a QR with the same products of columns; the matrix itself if it has fewer rows
/// than columns.
MatrixXd triangle(MatrixXd stacked) {
  if (stacked.rows() <= stacked.cols()) return stacked;
  const Index n = stacked.cols();
  const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> qr(stacked);
  return qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
}

}  // namespace

void validate(const ExplorationProblem& problem) {
  const Index nx = problem.A.rows(), nu = problem.B.cols();
  require(nx >= 1, "A is empty");
  require(nu >= 1, "B has no column; there must be at least one input");
  requireShape(problem.A, nx, nx, "A");
  requireShape(problem.B, nx, nu, "B");
  requireFinite(problem.A, "A");
  requireFinite(problem.B, "B");
  validate(problem.lines);
  requirePositive(problem.gamma_w, "gamma_w");
  if (problem.K.size() > 0) {
    requireShape(problem.K, nu, nx, "K");
    requireFinite(problem.K, "K");
  }
  if (problem.x0.size() > 0) {
    requireShape(problem.x0, nx, 1, "x0");
    requireFinite(problem.x0, "x0");
    require(problem.x0.isZero(0.0),
            "x0 is not zero; a start away from rest is not solved yet. Measure states relative "
            "to the start of the experiment");
  }
  requireShape(problem.D_des, problem.D_des.rows(), problem.D_des.rows(), "D_des");
  const MatrixXd D = fullCloseness(problem.D_des, problem.numStates(),
                                   problem.numRegressors());  // checks the shape
  const VectorXd eigenvalues = quad_support::symmetricEigenvalues(D);
  const double least = eigenvalues(0), largest = eigenvalues(D.rows() - 1);
  require(least > 1e-14 * largest,
          "D_des has the eigenvalue {}; all must be above 0 (the largest is {})", least, largest);
}

MatrixXd PredictedResponse::factor(const VectorXd& a) const {
  MatrixXd sum = MatrixXd::Zero(factors.front().rows(), factors.front().cols());
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

MatrixXd PredictedResponse::gramOf(const MatrixXd& Z) const {
  const int p = numAmplitudes();
  MatrixXd h(p, p);
  for (int a = 0; a < p; ++a) {
    const MatrixXd weighted = factors[static_cast<std::size_t>(a)] * Z;
    for (int b = 0; b <= a; ++b) {
      h(a, b) = h(b, a) = weighted.cwiseProduct(factors[static_cast<std::size_t>(b)]).sum();
    }
  }
  return h;
}

MatrixXd unitResponse(const ExplorationProblem& problem, int component) {
  validate(problem);
  require(component >= 0 && component < problem.numAmplitudes(), "component {}; must lie in 0..{}",
          component, problem.numAmplitudes() - 1);
  const MatrixXd signals = carriers(problem.lines, problem.phase);
  return responseTo(problem, signals.row(component / problem.numInputs()).transpose(),
                    component % problem.numInputs());
}

MatrixXd closenessInverseRoot(const ExplorationProblem& problem) {
  return quad_support::inverseSquareRoot(reducedCloseness(problem));
}

PredictedResponse predictResponse(const ExplorationProblem& problem) {
  validate(problem);
  const MatrixXd stacked = triangle(stackedResponses(problem));
  require(stacked.allFinite(),
          "the predicted response overflows: A grows too fast for T = {}. Stabilise with K or "
          "shorten T",
          problem.lines.num_samples);
  const MatrixXd root = closenessInverseRoot(problem);
  const Index n = problem.numRegressors();
  const bool kronecker = root.rows() == n;
  PredictedResponse response;
  for (int a = 0; a < problem.numAmplitudes(); ++a) {
    const MatrixXd block = stacked.middleCols(a * n, n);
    const MatrixXd identity = MatrixXd::Identity(problem.numStates(), problem.numStates());
    response.factors.push_back(
        kronecker ? MatrixXd(block * root)
                  : MatrixXd(Eigen::kroneckerProduct(block, identity).eval() * root));
  }
  return response;
}

}  // namespace explore_opt
