#include "dual_bound.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool logDet(const MatrixXd& m, double& value) {
  const Eigen::LLT<MatrixXd> llt(m);
  if (llt.info() != Eigen::Success) return false;
  value = 2.0 * llt.matrixL().toDenseMatrix().diagonal().array().log().sum();
  return std::isfinite(value);
}

/// Columns L⁻¹ E_k L⁻ᵀ for each k, with L Lᵀ = m: their products are tr(m⁻¹ E_k m⁻¹ E_l).
MatrixXd whitened(const MatrixXd& m, const std::vector<MatrixXd>& directions) {
  const Eigen::LLT<MatrixXd> llt(m);
  const auto L = llt.matrixL();
  MatrixXd columns(m.size(), static_cast<Index>(directions.size()));
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const MatrixXd half = L.solve(directions[k]);
    const MatrixXd both = L.solve(half.transpose());
    columns.col(static_cast<Index>(k)) = Eigen::Map<const VectorXd>(both.data(), both.size());
  }
  return columns;
}

/// Sum of the diagonals of the n x n matrices stored as columns.
VectorXd traces(const MatrixXd& columns, Index n) {
  VectorXd sum = VectorXd::Zero(columns.cols());
  for (Index i = 0; i < n; ++i) sum += columns.row(i * n + i).transpose();
  return sum;
}

/// Change of the barrier along Z + t D: φ(t) = slope t - Σ log(1 + t rates). The rates are
/// eigenvalues of D and of -2 H(D) relative to Z and to I - 2 H(Z); differences of the barrier's
/// values would drown in their rounding.
struct Ray {
  double slope;
  VectorXd rates;

  double longest() const {  // 0.99 of the way to the boundary, at most 1
    const double least = rates.minCoeff();
    return least < -0.99 ? -0.99 / least : 1.0;
  }
  double change(double t) const { return slope * t - (t * rates).array().log1p().sum(); }
};

VectorXd relativeEigenvalues(const MatrixXd& m, const MatrixXd& direction) {
  const MatrixXd white =
      Eigen::Map<const MatrixXd>(whitened(m, {direction}).data(), m.rows(), m.cols());
  return quad_support::symmetricEigenvalues(white);
}

/// One Newton step with backtracking; returns the Newton decrement before it, 0 if it cannot go on.
double newtonStep(const QuadraticProgram& program, const DualBarrier& barrier, double mu,
                  MatrixXd& Z) {
  VectorXd gradient;
  MatrixXd root;
  barrier.gradientAndRoot(Z, mu, gradient, root);
  // Hessian = rootᵀ root; its triangle from a QR keeps the digits that forming the product would
  // lose.
  const MatrixXd R = Eigen::HouseholderQR<MatrixXd>(root)
                         .matrixQR()
                         .topRows(root.cols())
                         .triangularView<Eigen::Upper>();
  const auto upper = R.triangularView<Eigen::Upper>();
  const VectorXd half = upper.transpose().solve(gradient);
  const VectorXd step = -upper.solve(half);
  const double square = -gradient.dot(step);
  if (!(square > 0.0) || !std::isfinite(square)) return 0.0;
  const MatrixXd direction = barrier.matrix(step);
  Ray ray;
  ray.slope = -program.rightSide().cwiseProduct(direction).sum() / mu;
  ray.rates.resize(program.size() + program.numAmplitudes());
  ray.rates << relativeEigenvalues(Z, direction),
      relativeEigenvalues(barrier.slack(Z), -2.0 * program.H(direction));
  for (double t = ray.longest(); t > 1e-8; t *= 0.5) {
    if (ray.change(t) > -0.1 * t * square) continue;
    Z += t * direction;
    return std::sqrt(square);
  }
  return 0.0;  // no progress in double precision: as centred as it gets
}

int centre(const QuadraticProgram& program, const DualBarrier& barrier, double mu, double decrement,
           MatrixXd& Z) {
  constexpr int kMaxSteps = 60;
  int steps = 0;
  while (steps < kMaxSteps && newtonStep(program, barrier, mu, Z) > decrement) ++steps;
  return steps + 1;
}

}  // namespace

DualBarrier::DualBarrier(const QuadraticProgram& program) : program_(program) {
  const int n = program.size();
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      MatrixXd E = MatrixXd::Zero(n, n);
      E(i, j) = E(j, i) = 1.0;
      basis_.push_back(E);
      images_.push_back(2.0 * program.H(E));
    }
  }
  reward_.resize(numVariables());
  for (int k = 0; k < numVariables(); ++k) {
    reward_(k) = program.rightSide().cwiseProduct(basis_[static_cast<std::size_t>(k)]).sum();
  }
}

MatrixXd DualBarrier::matrix(const VectorXd& z) const {
  MatrixXd Z = MatrixXd::Zero(program_.size(), program_.size());
  for (int k = 0; k < numVariables(); ++k) Z += z(k) * basis_[static_cast<std::size_t>(k)];
  return Z;
}

MatrixXd DualBarrier::slack(const MatrixXd& Z) const {
  const int p = program_.numAmplitudes();
  return MatrixXd::Identity(p, p) - 2.0 * program_.H(Z);
}

bool DualBarrier::value(const MatrixXd& Z, double mu, double& f) const {
  double first = 0.0, second = 0.0;
  if (!logDet(Z, first) || !logDet(slack(Z), second)) return false;
  f = -program_.rightSide().cwiseProduct(Z).sum() / mu - first - second;
  return true;
}

void DualBarrier::gradientAndRoot(const MatrixXd& Z, double mu, VectorXd& gradient,
                                  MatrixXd& root) const {
  const MatrixXd cone = whitened(Z, basis_), energy = whitened(slack(Z), images_);
  gradient =
      -reward_ / mu - traces(cone, program_.size()) + traces(energy, program_.numAmplitudes());
  root.resize(cone.rows() + energy.rows(), cone.cols());
  root << cone, energy;
}

DualSolution solveDual(const QuadraticProgram& program, double gap) {
  const DualBarrier barrier(program);
  const int n = program.size(), p = program.numAmplitudes();
  const MatrixXd identity = MatrixXd::Identity(n, n);
  const VectorXd eigenvalues = quad_support::symmetricEigenvalues(program.H(identity));
  DualSolution dual;
  dual.Z = identity / (4.0 * eigenvalues(p - 1));
  const double last = gap / (n + p);
  double mu = 0.1 / (n + p);  // the maximum is at most 1/2, the cost of the reference
  for (;;) {
    // The last centre is sharp: what remains of the gradient enters the lifted matrix many times
    // over.
    dual.newton_steps += centre(program, barrier, mu, mu <= last ? 1e-6 : 0.1, dual.Z);
    if (mu <= last) break;
    mu = std::max(last, 0.1 * mu);
  }
  dual.gap = (n + p) * mu;
  dual.lifted = 2.0 * mu * barrier.slack(dual.Z).llt().solve(MatrixXd::Identity(p, p));
  return dual;
}

}  // namespace explore_opt
