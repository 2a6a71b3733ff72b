#include <fmt/core.h>

#include <cmath>

#include "checks.hpp"
#include "constants.hpp"
#include "constraint_shape.hpp"
#include "design_tools.hpp"
#include "quad_support/linear_algebra.hpp"
#include "response_root.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDependent = 1e-7;  // of the largest singular value: half of a double's digits

/// (2/T) Σ ‖u_k‖² = ‖R a + r‖² + rest, from one QR of the inputs' responses.
AmplitudeMap inputEnergyMap(const ExplorationProblem& problem, const ResponseRoot& root) {
  const Index p = problem.numAmplitudes(), nu = problem.numInputs();
  const Index rows = root.blocks.front().rows();
  MatrixXd inputs = MatrixXd::Zero(std::max(rows * nu, p + 1), p + 1);
  for (std::size_t a = 0; a < root.blocks.size(); ++a) {
    const MatrixXd u = root.blocks[a].rightCols(nu);
    inputs.col(static_cast<Index>(a)).head(rows * nu) = u.reshaped();
  }
  inputs *= std::sqrt(2.0 / problem.lines.num_samples);
  const MatrixXd R = quad_support::triangularFactor(inputs);
  const MatrixXd energy = R.topLeftCorner(p, p);
  const VectorXd sigma = quad_support::singularValues(energy);
  require(sigma(p - 1) > kDependent * sigma(0),
          "cost = input: the energy of the input does not determine the amplitudes (T = {}, {} "
          "components, singular values {} to {}); use cost = signal",
          problem.lines.num_samples, p, sigma(p - 1), sigma(0));
  AmplitudeMap map;
  map.shape = energy.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(p, p));
  if (!R.col(p).isZero(0.0)) {
    map.centre = -map.shape * R.col(p).head(p);
    map.floor = R(p, p) * R(p, p);
  }
  return map;
}

/// The response in the coordinates of `map`.
PredictedResponse mapped(const PredictedResponse& response, const AmplitudeMap& map) {
  if (map.shape.size() == 0) return response;
  PredictedResponse out;
  if (!response.homogeneous() || map.centre.size() > 0) {
    out.offset = response.homogeneous()
                     ? MatrixXd::Zero(response.factors.front().rows(), response.size())
                     : response.offset;
    for (Index a = 0; a < map.centre.size(); ++a)
      out.offset += map.centre(a) * response.factors[static_cast<std::size_t>(a)];
  }
  for (Index b = 0; b < map.shape.cols(); ++b) {
    MatrixXd F = MatrixXd::Zero(response.factors.front().rows(), response.size());
    for (Index a = 0; a <= b; ++a)
      F += map.shape(a, b) * response.factors[static_cast<std::size_t>(a)];
    out.factors.push_back(std::move(F));
  }
  return out;
}

/// The directions of regressors that no amplitudes excite: n_φ minus the rank of all responses.
int rankOfAllResponses(const DesignTask& task) {
  const Index rows = task.response.factors.front().rows(), n = task.response.size();
  MatrixXd all(rows * task.response.numAmplitudes(), n);
  for (int a = 0; a < task.response.numAmplitudes(); ++a)
    all.middleRows(a * rows, rows) = task.response.factors[static_cast<std::size_t>(a)];
  const VectorXd lengths = all.colwise().norm().cwiseMax(1e-300);
  const VectorXd sigma = quad_support::singularValues(
      quad_support::triangularFactor(all * lengths.cwiseInverse().asDiagonal()));
  int rank = 0;
  while (rank < sigma.size() && sigma(rank) > kDependent * sigma(0)) ++rank;
  return rank;
}

/// Dimension of the states the inputs can reach, from the controllability matrix column by column,
/// each scaled so that growth does not hide directions.
int reachableDimension(const MatrixXd& A, const MatrixXd& B) {
  const Index n = A.rows();
  MatrixXd basis(n, 0), next = B;
  for (Index step = 0; step < n; ++step) {
    for (Index j = 0; j < next.cols(); ++j) {
      VectorXd v = next.col(j);
      const double length = v.norm();
      for (int twice = 0; twice < 2; ++twice) v -= basis * (basis.transpose() * v).eval();
      if (!(v.norm() > 1e-9 * length) || basis.cols() == n) continue;
      basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
      basis.rightCols(1) = v.normalized();
    }
    next = A * next;
    const double size = next.cwiseAbs().maxCoeff();
    if (!(size > 0.0)) break;
    next /= size;
  }
  return static_cast<int>(basis.cols());
}

}  // namespace

DesignTask taskOf(const ExplorationProblem& problem) {
  const PredictedResponse response = predictResponse(problem);
  const ConstraintShape shape(problem);
  DesignTask task;
  task.gamma_w = problem.gamma_w;
  task.num_inputs = problem.numInputs();
  if (!shape.required().isIdentity(0.0)) task.required = shape.required();
  if (problem.cost == CostOn::kInput) task.map = inputEnergyMap(problem, responseRoot(problem));
  task.response = mapped(response, task.map);
  return task;
}

bool isSmallEnough(const DesignTask& task) {
  constexpr int kMost = 1200;
  const int n = task.response.size(), p = task.response.numAmplitudes();
  return std::min(n * (n + 1), p * (p + 1)) / 2 <= kMost;
}

namespace {

std::string reasonNothingExcites(const ExplorationProblem& problem, const DesignTask& task) {
  const int nx = problem.numStates(), n_phi = problem.numRegressors(), L = problem.lines.size();
  const int reachable = reachableDimension(problem.A, problem.B);
  if (reachable < nx) {
    return fmt::format(
        "(A, B) is not controllable: the inputs reach {} of {} state directions; declare what they "
        "cannot reach as known, or leave those states out",
        reachable, nx);
  }
  if (problem.lines.num_samples < n_phi) {
    return fmt::format("T = {} samples cannot determine {} regressors; T must be at least {}",
                       problem.lines.num_samples, n_phi, n_phi);
  }
  const int rank = rankOfAllResponses(task), all = task.response.size();
  const double growth = modeGrowth(problem);
  if (growth > 1.0 / kDependent) {
    const std::string some = rank < all ? fmt::format("only {} of", rank) : "not all";
    return fmt::format(
        "the modes of {} grow {:.0e}-fold within T = {}, and beside them {} lines excite {} {} "
        "directions. {}, or add lines",
        dynamicsName(problem), growth, problem.lines.num_samples, L, some, all,
        growthRemedy(problem));
  }
  if (rank < all) {
    return fmt::format(
        "{} lines excite only {} of {} directions; add lines (two directions each in steady state)",
        L, rank, all);
  }
  return fmt::format(
      "no amplitudes of these {} lines excite all {} directions at once; add lines, use both "
      "phases, or a longer T",
      L, all);
}

/// Whether the lines would excite everything from rest.
bool excitesFromRest(DesignTask task) {
  task.response.offset.resize(0, 0);
  return cheapestSimpleDirection(task, 1).has_value();
}

}  // namespace

void refuseToExcite(const ExplorationProblem& problem, const DesignTask& task, RawDesign& design) {
  if (task.response.homogeneous() || !excitesFromRest(task)) {
    design.status = DesignStatus::kNotExciting;
    design.message = reasonNothingExcites(problem, task);
    return;
  }
  design.status = DesignStatus::kNumericalError;
  design.message = fmt::format(
      "the response to x0 (norm {:.3g}) outweighs what the lines must add so far that doubles do "
      "not resolve both; start nearer to rest, or ask for more (D_des)",
      problem.x0.norm());
}

}  // namespace explore_opt
