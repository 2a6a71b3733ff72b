/// Feasibility and lower bound of a design from the raw data, in long double where it matters, with
/// no code of the library.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <vector>

#include "explore_opt/exploration_design.hpp"

namespace explore_opt::testing {

using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// φ_0 ... φ_{T-1} from x_0 (`from_start`) or from rest.
inline RealMatrix rawRegressor(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes,
                               bool from_start = true) {
  const int T = problem.lines.num_samples, L = problem.lines.size(), nx = problem.numStates(),
            nu = problem.numInputs();
  const RealMatrix A = problem.A.cast<Real>(), B = problem.B.cast<Real>(),
                   K = problem.K.cast<Real>(), alpha = amplitudes.cast<Real>();
  const Real turn = 2 * std::acos(Real(-1));
  RealVector x = RealVector::Zero(nx);
  if (from_start && problem.x0.size() > 0) x = problem.x0.cast<Real>();
  RealMatrix phi(nx + nu, T);
  for (int k = 0; k < T; ++k) {
    RealVector u = RealVector::Zero(nu);
    if (problem.K.size() > 0) u = K * x;
    for (int i = 0; i < L; ++i) {
      const auto line = static_cast<std::size_t>(i);
      const Real angle =
          problem.lines.harmonics.empty()
              ? turn * Real(problem.lines.frequencies[line]) * k
              : turn * Real((std::int64_t(problem.lines.harmonics[line]) * k) % T) / T;
      const Real c = std::cos(angle), s = std::sin(angle);
      u += (problem.phase == Phase::kSin ? s : c) * alpha.row(i).transpose();
      if (problem.phase == Phase::kBoth) u += s * alpha.row(L + i).transpose();
    }
    phi.col(k) << x, u;
    x = A * x + B * u;
  }
  return phi;
}

/// D_des as a matrix of size n_φ n_x, and the unknown entries of θ.
inline RealMatrix rawCloseness(const ExplorationProblem& problem) {
  const int n = problem.numRegressors(), nx = problem.numStates();
  if (problem.D_des.rows() == n * nx) return problem.D_des.cast<Real>();
  RealMatrix D = RealMatrix::Zero(n * nx, n * nx);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Real d = problem.D_des.size() > 1 ? Real(problem.D_des(i, j))
                     : i == j                 ? Real(problem.D_des(0, 0))
                                              : Real(0);
      for (int k = 0; k < nx; ++k) D(i * nx + k, j * nx + k) = d;
    }
  }
  return D;
}

/// The largest ratio G/γ_w with Eᵀ(Q ⊗ I)E ⪰ G EᵀDE: 1/λ_max of D relative to Q. From a QR of the
/// T samples: with products of samples the answer would be that of the rounding where the condition
/// number of Φ passes 1e6 (unstable systems).
inline double rawLambdaMin(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes) {
  const int n = problem.numRegressors(), nx = problem.numStates();
  const RealMatrix samples = rawRegressor(problem, amplitudes).transpose();
  RealMatrix R = RealMatrix::Zero(std::max<Eigen::Index>(samples.rows(), n), n);
  R.topRows(samples.rows()) = samples;
  R = RealMatrix(Eigen::HouseholderQR<RealMatrix>(R).matrixQR().topRows(n));
  const bool kronecker = problem.D_des.rows() != n * nx;
  std::vector<Eigen::Index> entries;
  const int rows = kronecker && problem.known.size() == 0 ? 1 : nx;  // else they repeat
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < rows; ++i) {
      if (problem.known.size() == 0 || std::isnan(problem.known(i, j)))
        entries.push_back(j * nx + i);
    }
  }
  const auto m = static_cast<Eigen::Index>(entries.size());
  const RealMatrix D = rawCloseness(problem);
  RealMatrix root = RealMatrix::Zero(n * rows, m), wanted(m, m);  // columns of R ⊗ I
  for (Eigen::Index a = 0; a < m; ++a) {
    const auto i = entries[std::size_t(a)];
    for (int k = 0; k <= i / nx; ++k) root(k * rows + i % nx, a) = R(k, i / nx);
    for (Eigen::Index b = 0; b < m; ++b) wanted(a, b) = D(i, entries[std::size_t(b)]);
  }
  const RealVector scale = root.colwise().norm().cwiseInverse();
  root = (root * scale.asDiagonal()).eval();
  wanted = (scale.asDiagonal() * wanted * scale.asDiagonal()).eval();
  const RealMatrix U = Eigen::HouseholderQR<RealMatrix>(root).matrixQR().topRows(m);
  if (!(U.diagonal().cwiseAbs().minCoeff() > Real(0))) return 0.0;
  const auto lower = U.transpose().triangularView<Eigen::Lower>();
  RealMatrix half = lower.solve(wanted);
  half = lower.solve(RealMatrix(half.transpose()));
  const Real largest =
      Eigen::SelfAdjointEigenSolver<RealMatrix>(half).eigenvalues()(half.rows() - 1);
  return static_cast<double>(1 / (largest * Real(problem.gamma_w)));
}

/// The bound `result.multiplier_root` and `peak_multipliers` prove: the least value over a of
/// ½γ_e(a)² - tr M(Q(a)[⊗ I] - γ_w D) + Σ ½ν_k(‖u_k(a)‖² - u_max²), as a norm. The quadratic is
/// found from unit responses; a multiplier for θ enters through its sum over the rows of Θ.
inline double rawBound(const ExplorationProblem& problem, const DesignResult& result) {
  const int n = problem.numRegressors(), nx = problem.numStates(), nu = problem.numInputs(),
            p = problem.numAmplitudes(), T = problem.lines.num_samples;
  const RealMatrix Y = result.multiplier_root.cast<Real>(), D = rawCloseness(problem);
  const auto r = Y.cols();
  RealMatrix root(Y.rows() == n ? r : r * nx, n);  // ‖root φ‖² = tr(Y Yᵀ(φφᵀ [⊗ I]))
  Real reward = 0;
  if (Y.rows() == n) {
    root = Y.transpose();
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) reward += Y.row(i).dot(Y.row(j)) * D(i * nx, j * nx);
  } else {
    for (int j = 0; j < n; ++j) root.col(j) = Y.middleRows(j * nx, nx).reshaped();
    reward = Y.cwiseProduct(D * Y).sum();
  }
  std::vector<RealMatrix> responses;  // to each component, and to x_0
  for (int a = 0; a < p; ++a) {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(p / nu, nu);
    unit(a / nu, a % nu) = 1.0;
    responses.push_back(rawRegressor(problem, unit, false));
  }
  responses.push_back(rawRegressor(problem, Eigen::MatrixXd::Zero(p / nu, nu), true));
  RealMatrix stacked(root.rows() * T, p + 1), inputs(nu * T, p + 1);
  for (int a = 0; a <= p; ++a) {
    const RealMatrix& phi = responses[std::size_t(a)];
    stacked.col(a) = (root * phi).reshaped();
    inputs.col(a) = phi.bottomRows(nu).reshaped();
  }
  RealMatrix P = -2 * stacked.transpose() * stacked;  // twice the Lagrangian, [a; 1]
  if (problem.cost == CostOn::kInput) {
    P += Real(2) / T * inputs.transpose() * inputs;
  } else {
    P.topLeftCorner(p, p) += RealMatrix::Identity(p, p);
  }
  P(p, p) += 2 * Real(problem.gamma_w) * reward;
  for (const PeakMultiplier& peak : result.peak_multipliers) {
    const int first = peak.sample * nu + std::max(peak.input, 0), count = peak.input < 0 ? nu : 1;
    const RealMatrix u = inputs.middleRows(first, count);
    const Real limit = problem.u_max(peak.input < 0 || problem.u_max.size() == 1 ? 0 : peak.input);
    P += Real(peak.value) * u.transpose() * u;
    P(p, p) -= Real(peak.value) * limit * limit;
  }
  const RealMatrix aa = P.topLeftCorner(p, p);
  // Positive semidefinite but for rounding: the bound of the library keeps 1e-13 of distance.
  if (Eigen::SelfAdjointEigenSolver<RealMatrix>(aa).eigenvalues()(0) < -1e-9) return 0.0;
  const RealVector g = P.col(p).head(p);
  Real value = P(p, p);
  if (!g.isZero(Real(0))) value -= g.dot(RealVector(aa.ldlt().solve(g)));
  return static_cast<double>(std::sqrt(std::max(value, Real(0))));
}

}  // namespace explore_opt::testing
