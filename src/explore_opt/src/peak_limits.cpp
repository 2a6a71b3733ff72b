#include "peak_limits.hpp"

#include <algorithm>
#include <cmath>

#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One limit for all inputs together (row 0), or one a row. A single input needs no norm.
bool onNorm(const ExplorationProblem& problem) {
  return problem.u_max.size() == 1 && problem.numInputs() > 1;
}

/// |u|/u_max, limits x T.
MatrixXd ratios(const ExplorationProblem& problem, const MatrixXd& amplitudes) {
  const MatrixXd u = predictedInputs(problem, amplitudes);
  if (onNorm(problem)) return u.colwise().norm() / problem.u_max(0);
  return problem.u_max.cwiseInverse().asDiagonal() * u.cwiseAbs();
}

/// Inputs at the given samples with unit amplitude of each component and, last, from x_0 alone:
/// [n_u x (p + 1)] a sample. One pass over the horizon, nothing T-long kept.
std::vector<MatrixXd> inputsAt(const ExplorationProblem& problem, const std::vector<int>& samples) {
  const int nx = problem.numStates(), nu = problem.numInputs(), p = problem.numAmplitudes(),
            L = problem.lines.size();
  std::vector<MatrixXd> found;
  MatrixXd x = MatrixXd::Zero(nx, p + 1);
  if (problem.x0.size() > 0) x.col(p) = problem.x0;
  for (int k = 0; found.size() < samples.size(); ++k) {
    MatrixXd u = MatrixXd::Zero(nu, p + 1);
    for (int a = 0; a < p; ++a) {
      const int carrier = a / nu;
      const CarrierValue turn = carrierAt(problem.lines, carrier % L, k);
      const bool sine =
          problem.phase == Phase::kSin || (problem.phase == Phase::kBoth && carrier >= L);
      u(a % nu, a) = sine ? turn.sine : turn.cosine;
    }
    if (problem.K.size() > 0) {
      u += problem.K * x;
      x = (problem.A * x + problem.B * u).eval();
    }
    if (samples[found.size()] == k) found.push_back(u);
  }
  return found;
}

struct Peak {
  double ratio;
  int sample, row;
};

}  // namespace

double peakRatio(const ExplorationProblem& problem, const MatrixXd& amplitudes) {
  return ratios(problem, amplitudes).maxCoeff();
}

std::vector<PeakConstraint> bindingPeaks(const ExplorationProblem& problem, const DesignTask& task,
                                         const MatrixXd& amplitudes, double margin,
                                         std::size_t most) {
  const MatrixXd ratio = ratios(problem, amplitudes);
  const bool norm = onNorm(problem);
  std::vector<Peak> peaks;
  for (Index j = 0; j < ratio.rows(); ++j) {
    for (Index k = 0; k < ratio.cols(); ++k) {
      const double now = ratio(j, k);
      const bool local =
          (k == 0 || ratio(j, k - 1) <= now) && (k + 1 == ratio.cols() || ratio(j, k + 1) < now);
      if (!local || now < 1.0 - margin) continue;
      const int input = norm ? -1 : static_cast<int>(j);
      const bool there = std::any_of(task.peaks.begin(), task.peaks.end(), [&](const auto& p) {
        return p.sample == k && p.input == input;
      });
      if (!there) peaks.push_back({now, static_cast<int>(k), static_cast<int>(j)});
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak& a, const Peak& b) { return a.ratio > b.ratio; });
  if (peaks.size() > most) peaks.resize(most);
  std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) {
    return a.sample < b.sample || (a.sample == b.sample && a.row < b.row);
  });
  std::vector<int> samples;
  for (const Peak& peak : peaks) {
    if (samples.empty() || samples.back() != peak.sample) samples.push_back(peak.sample);
  }
  const std::vector<MatrixXd> inputs = inputsAt(problem, samples);
  std::vector<PeakConstraint> constraints;
  std::size_t at = 0;
  const Index p = problem.numAmplitudes();
  for (const Peak& peak : peaks) {
    while (samples[at] != peak.sample) ++at;
    const MatrixXd u = norm ? inputs[at] : MatrixXd(inputs[at].row(peak.row));
    PeakConstraint constraint;
    constraint.sample = peak.sample;
    constraint.input = norm ? -1 : peak.row;
    constraint.limit = problem.u_max(norm ? 0 : peak.row);
    constraint.rows = task.map.shape.size() > 0 ? MatrixXd(u.leftCols(p) * task.map.shape)
                                                : MatrixXd(u.leftCols(p));
    constraint.offset = u.col(p);
    if (task.map.centre.size() > 0) constraint.offset += u.leftCols(p) * task.map.centre;
    constraints.push_back(std::move(constraint));
  }
  return constraints;
}

double largestCost(const ExplorationProblem& problem, const DesignTask& task) {
  ExplorationProblem on_input = problem;
  on_input.cost = CostOn::kInput;
  const double largest = std::sqrt(2.0) * problem.u_max.norm();
  if (problem.cost == CostOn::kInput) return largest;
  const AmplitudeMap map = taskOf(on_input).map;
  double size = quad_support::singularValues(map.shape)(0) * largest;
  if (map.centre.size() > 0) size += map.centre.norm();
  return std::sqrt(size * size + task.map.floor);
}

}  // namespace explore_opt
