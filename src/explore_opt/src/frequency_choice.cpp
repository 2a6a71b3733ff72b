#include "explore_opt/frequency_choice.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>

#include "checks.hpp"
#include "constants.hpp"
#include "constraint_shape.hpp"
#include "explore_opt/set_membership.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kCandidates = 1000;
constexpr int kSteps = 500;

/// Harmonics in the band, below T/2; all, or about kCandidates of them at equal ratios.
std::vector<int> candidates(int T, const FrequencyOptions& options) {
  const double first = std::max(1.0, std::ceil(options.band_low * T - 1e-9));
  const double last = std::min((T - 1) / 2, static_cast<int>(options.band_high * T + 1e-9));
  require(first <= last, "band {} to {} holds no harmonic of T = {} below 1/2", options.band_low,
          options.band_high, T);
  std::vector<int> grid;
  const double ratio = std::pow(last / first, 1.0 / kCandidates);
  for (double h = first; h <= last; h = std::max(grid.back() + 1.0, std::floor(h * ratio)))
    grid.push_back(static_cast<int>(h));
  return grid;
}

/// Regressors per unit of each input at one frequency, real part [n_φ x n_u] beside the imaginary
/// one; empty at a pole.
MatrixXd response(const ExplorationProblem& problem, double frequency) {
  const Index nx = problem.numStates(), nu = problem.numInputs();
  const double angle = kTwoPi * frequency;
  const MatrixXd A = problem.dynamics(), eye = MatrixXd::Identity(nx, nx);
  // (z I − A)(X + iY) = B, its real and its imaginary part.
  MatrixXd resolvent(2 * nx, 2 * nx), rhs = MatrixXd::Zero(2 * nx, nu);
  resolvent << std::cos(angle) * eye - A, -std::sin(angle) * eye, std::sin(angle) * eye,
      std::cos(angle) * eye - A;
  rhs.topRows(nx) = problem.B;
  const MatrixXd state = resolvent.partialPivLu().solve(rhs);
  MatrixXd V = MatrixXd::Zero(nx + nu, 2 * nu);
  V.topLeftCorner(nx, nu) = state.topRows(nx);
  V.topRightCorner(nx, nu) = state.bottomRows(nx);
  V.bottomLeftCorner(nu, nu).setIdentity();
  if (problem.K.size() > 0) V.bottomRows(nu) += problem.K * V.topRows(nx);
  return V.allFinite() && V.norm() < 1e12 ? V : MatrixXd();
}

/// Closeness of the regressors, n_φ x n_φ: D of D ⊗ I; of a full D_des the sum over the rows of Θ,
/// of their unknown entries. Directions nobody asks for count a millionth.
MatrixXd regressorCloseness(const ExplorationProblem& problem) {
  const int n = problem.numRegressors(), nx = problem.numStates();
  const auto unknown = [&](int i, int j) {
    return problem.known.size() == 0 || std::isnan(problem.known(i, j));
  };
  MatrixXd D = problem.D_des;
  if (D.size() == 1) D = MatrixXd(D(0, 0) * MatrixXd::Identity(n, n));
  if (D.rows() != n) {
    MatrixXd sum = MatrixXd::Zero(n, n);
    for (int j = 0; j < n; ++j) {
      for (int l = 0; l < n; ++l) {
        for (int i = 0; i < nx; ++i)
          if (unknown(i, j) && unknown(i, l)) sum(j, l) += D(j * nx + i, l * nx + i);
      }
    }
    D = sum;
  }
  const double largest = quad_support::symmetricEigenvalues(problem.D_des).tail(1)(0);
  return D + 1e-6 * largest * MatrixXd::Identity(n, n);
}

/// Σ p_h N_h = RᵀR in axes of its own: singular values of R and its right singular vectors. From
/// the roots, not from the products: an integrator's gains differ by 1e10 on a long grid, their
/// squares by more than doubles resolve.
struct Axes {
  VectorXd sigma;
  MatrixXd vectors;
};

Axes axesOf(const std::vector<MatrixXd>& roots, const VectorXd& p) {
  const Index rows = roots.front().rows(), n = roots.front().cols();
  MatrixXd stacked(rows * p.size(), n);
  for (Index h = 0; h < p.size(); ++h)
    stacked.middleRows(h * rows, rows) = std::sqrt(p(h)) * roots[static_cast<std::size_t>(h)];
  if (stacked.rows() < n) return {VectorXd::Zero(n), MatrixXd::Identity(n, n)};
  const MatrixXd R = quad_support::triangularFactor(stacked);
  return {quad_support::singularValues(R), quad_support::leftSingularVectors(R.transpose())};
}

/// Multiplicative steps p_h <- p_h (tr(M⁻⁴ N_h)/tr M⁻³)^{1/4}, normalised.
/// @param roots  N_h = R_hᵀ R_h
VectorXd bestSpectrum(const std::vector<MatrixXd>& roots) {
  const auto count = static_cast<Index>(roots.size());
  VectorXd p = VectorXd::Constant(count, 1.0 / static_cast<double>(count)), gains(count);
  for (int step = 0; step < kSteps; ++step) {
    const Axes axes = axesOf(roots, p);
    const double least = axes.sigma.minCoeff();
    if (!(least > 1e-14 * axes.sigma.maxCoeff())) {
      throw quad_support::NegativeAnswer(
          "no signal on these harmonics excites all unknown parameters in steady state: is (A, B) "
          "controllable, and the band wide enough? What the inputs cannot reach can be declared "
          "known");
    }
    const VectorXd weights = (least * axes.sigma.cwiseInverse()).array().pow(4.0);  // M⁻², rooted
    const MatrixXd turn = axes.vectors * weights.asDiagonal();
    for (Index h = 0; h < count; ++h)
      gains(h) = (roots[static_cast<std::size_t>(h)] * turn).squaredNorm();
    p.array() *= (gains.array() / p.dot(gains)).pow(0.25);
    p /= p.sum();
  }
  return p;
}

/// For each candidate the place in `chosen` of the nearest one.
std::vector<std::size_t> nearestChosen(int candidates, const std::vector<int>& chosen) {
  std::vector<std::size_t> places;
  for (int i = 0; i < candidates; ++i) {
    std::size_t nearest = 0;
    for (std::size_t c = 1; c < chosen.size(); ++c) {
      if (std::abs(chosen[c] - i) < std::abs(chosen[nearest] - i)) nearest = c;
    }
    places.push_back(nearest);
  }
  return places;
}

/// One more candidate: the middle, by power, of what the busiest line stands for beside itself.
int middleOfTheBusiest(const VectorXd& power, const std::vector<int>& chosen) {
  const auto n = static_cast<int>(power.size());
  const std::vector<std::size_t> places = nearestChosen(n, chosen);
  const auto isChosen = [&](int i) { return chosen[places[static_cast<std::size_t>(i)]] == i; };
  VectorXd others = VectorXd::Constant(static_cast<Index>(chosen.size()), -1.0);  // has none
  for (int i = 0; i < n; ++i) {
    double& sum = others(static_cast<Index>(places[static_cast<std::size_t>(i)]));
    if (!isChosen(i)) sum = std::max(sum, 0.0) + power(i);
  }
  Index busiest = 0;
  const double half = 0.5 * others.maxCoeff(&busiest);
  double sum = 0.0;
  int last = 0;
  for (int i = 0; i < n; ++i) {
    if (static_cast<Index>(places[static_cast<std::size_t>(i)]) != busiest || isChosen(i)) continue;
    last = i;
    sum += power(i);
    if (sum >= half) break;
  }
  return last;
}

/// The highest peaks; where a broad spectrum has fewer, its stretches are halved until there are
/// lines enough. Every candidate's power goes to the nearest line.
void pickLines(int count, FrequencyChoice& choice) {
  const auto n = static_cast<int>(choice.grid.size());
  const auto isPeak = [&](int i) {
    return (i == 0 || choice.power(i) >= choice.power(i - 1)) &&
           (i == n - 1 || choice.power(i) > choice.power(i + 1));
  };
  std::vector<int> chosen;
  for (int i = 0; i < n; ++i) {
    if (isPeak(i)) chosen.push_back(i);
  }
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](int a, int b) { return choice.power(a) > choice.power(b); });
  if (static_cast<int>(chosen.size()) > count) chosen.resize(static_cast<std::size_t>(count));
  while (static_cast<int>(chosen.size()) < std::min(count, n))
    chosen.push_back(middleOfTheBusiest(choice.power, chosen));
  std::sort(chosen.begin(), chosen.end());
  choice.shares.assign(chosen.size(), 0.0);
  const std::vector<std::size_t> places = nearestChosen(n, chosen);
  for (int i = 0; i < n; ++i) choice.shares[places[static_cast<std::size_t>(i)]] += choice.power(i);
  for (const int i : chosen) choice.harmonics.push_back(choice.grid[static_cast<std::size_t>(i)]);
}

}  // namespace

FrequencyChoice chooseFrequencies(const ExplorationProblem& problem,
                                  const FrequencyOptions& options) {
  validate(problem);
  const int T = problem.lines.num_samples, nu = problem.numInputs();
  require(options.lines >= 0 && options.lines <= 10000, "lines = {}; must be 0 to 10000",
          options.lines);
  require(
      options.band_low >= 0.0 && options.band_low < options.band_high && options.band_high <= 0.5,
      "band = {} to {}; must be 0 <= low < high <= 1/2 cycles per sample", options.band_low,
      options.band_high);
  const double radius = quad_support::spectralRadius(problem.dynamics());
  if (radius > 1.0 + 1e-6) {  // the error of a double eigenvalue of 1 is 1e-8
    throw quad_support::NegativeAnswer(
        fmt::format("the system is unstable (spectral radius {:.6g}): there is no steady state to "
                    "choose lines by. Add a stabilising K",
                    radius));
  }
  ExplorationProblem asked = problem;
  asked.D_des = regressorCloseness(problem);
  const ConstraintShape shape(asked);
  FrequencyChoice choice;
  std::vector<MatrixXd> roots;
  std::vector<MatrixXd> responses;
  for (const int h : candidates(T, options)) {
    const MatrixXd V = response(problem, static_cast<double>(h) / T);
    if (V.size() == 0) continue;
    choice.grid.push_back(h);
    responses.push_back(V);
    // Re(V Vᴴ) = Re V Re Vᵀ + Im V Im Vᵀ
    roots.push_back(shape.factor(std::sqrt(0.5 * T) * V.transpose()));
  }
  require(!choice.grid.empty(), "every harmonic of the band is a pole of the system");
  choice.power = bestSpectrum(roots);
  choice.gain.resize(static_cast<Index>(choice.grid.size()), problem.numStates() * nu);
  choice.phase = choice.gain;
  for (std::size_t h = 0; h < responses.size(); ++h) {
    for (int i = 0; i < problem.numStates(); ++i) {
      for (int j = 0; j < nu; ++j) {
        const std::complex<double> gain(responses[h](i, j), responses[h](i, nu + j));
        choice.gain(static_cast<Index>(h), i * nu + j) = std::abs(gain);
        choice.phase(static_cast<Index>(h), i * nu + j) = std::arg(gain);
      }
    }
  }
  pickLines(options.lines == 0 ? problem.numRegressors() : options.lines, choice);
  return choice;
}

}  // namespace explore_opt
