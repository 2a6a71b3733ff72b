/// The design problem of thesis section 2.4, and plain simulation to check designs with.
#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "explore_opt/altitude_model.hpp"
#include "explore_opt/exploration_problem.hpp"
#include "quad_support/random_stream.hpp"

namespace explore_opt::testing {

inline ExplorationProblem thesisProblem(Phase phase, int num_samples = 370) {
  const LinearSystem nominal = altitudeModel(0.6247, 0.1635, 0.0);
  ExplorationProblem problem;
  problem.A = nominal.A;
  problem.B = nominal.B;
  problem.lines = {num_samples, {3, 6, 8, 10}, {}};
  problem.phase = phase;
  problem.gamma_w = 20.0;
  problem.D_des = Eigen::MatrixXd::Constant(1, 1, 100.0);
  return problem;
}

inline Eigen::MatrixXd randomMatrix(std::uint64_t seed, std::uint64_t stream, int rows, int cols) {
  const quad_support::RandomStream random(seed, 1, stream);
  Eigen::MatrixXd m(rows, cols);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j)
      m(i, j) = random.normal(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j));
  }
  return m;
}

/// φ_0 ... φ_{T-1} of the nominal system from rest, sample by sample with std::sin and std::cos: no
/// code in common with the library.
inline Eigen::MatrixXd simulatedRegressor(const ExplorationProblem& problem,
                                          const Eigen::MatrixXd& amplitudes) {
  const int T = problem.lines.num_samples, L = problem.lines.size(), nx = problem.numStates(),
            nu = problem.numInputs();
  Eigen::MatrixXd phi(nx + nu, T);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(nx);
  for (int k = 0; k < T; ++k) {
    Eigen::VectorXd u =
        problem.K.size() > 0 ? Eigen::VectorXd(problem.K * x) : Eigen::VectorXd::Zero(nu);
    for (int i = 0; i < L; ++i) {
      const double f = problem.lines.harmonics.empty()
                           ? problem.lines.frequencies[static_cast<std::size_t>(i)]
                           : problem.lines.harmonics[static_cast<std::size_t>(i)] / double(T);
      const double angle = 2.0 * M_PI * f * k;
      if (problem.phase == Phase::kSin) u += std::sin(angle) * amplitudes.row(i).transpose();
      if (problem.phase != Phase::kSin) u += std::cos(angle) * amplitudes.row(i).transpose();
      if (problem.phase == Phase::kBoth) u += std::sin(angle) * amplitudes.row(L + i).transpose();
    }
    phi.col(k) << x, u;
    x = problem.A * x + problem.B * u;
  }
  return phi;
}

/// A ⊗ I.
inline Eigen::MatrixXd kroneckerIdentity(const Eigen::MatrixXd& m, int n) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m.rows() * n, m.cols() * n);
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < m.cols(); ++j) {
      for (int k = 0; k < n; ++k) out(i * n + k, j * n + k) = m(i, j);
    }
  }
  return out;
}

/// D^{-1/2}, and M ⊗ I if D has the full size, else M, between two of them.
inline Eigen::MatrixXd normalised(const ExplorationProblem& problem, const Eigen::MatrixXd& M) {
  const int n = problem.numRegressors();
  const Eigen::MatrixXd D =
      problem.D_des.size() == 1
          ? Eigen::MatrixXd(problem.D_des(0, 0) * Eigen::MatrixXd::Identity(n, n))
          : problem.D_des;
  const Eigen::MatrixXd root =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(D).operatorInverseSqrt();
  return root * (D.rows() == n ? M : kroneckerIdentity(M, problem.numStates())) * root;
}

inline double smallestEigenvalue(const Eigen::MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues()(0);
}

/// λ_min(N(a))/γ_w from a simulation.
inline double simulatedLambdaMin(const ExplorationProblem& problem,
                                 const Eigen::MatrixXd& amplitudes) {
  const Eigen::MatrixXd phi = simulatedRegressor(problem, amplitudes);
  return smallestEigenvalue(normalised(problem, phi * phi.transpose())) / problem.gamma_w;
}

/// sqrt(γ_w tr Z/λ_max(H(Z))), H(Z)_ab = tr(Z S_ab), from simulated unit responses.
inline double auditedBound(const ExplorationProblem& problem, const Eigen::MatrixXd& Z) {
  const int rows = numCarriers(problem.lines, problem.phase), nu = problem.numInputs(),
            p = rows * nu;
  std::vector<Eigen::MatrixXd> responses;
  for (int a = 0; a < p; ++a) {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(rows, nu);
    unit(a / nu, a % nu) = 1.0;
    responses.push_back(simulatedRegressor(problem, unit));
  }
  Eigen::MatrixXd H(p, p);
  for (int a = 0; a < p; ++a) {
    for (int b = 0; b < p; ++b) {
      const Eigen::MatrixXd M = responses[static_cast<std::size_t>(a)] *
                                responses[static_cast<std::size_t>(b)].transpose();
      H(a, b) = (Z * normalised(problem, 0.5 * (M + M.transpose()))).trace();
    }
  }
  return std::sqrt(problem.gamma_w * Z.trace() /
                   Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues()(p - 1));
}

}  // namespace explore_opt::testing
