#include "lmi_solver.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lmi_point.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxIterations = 80;

}  // namespace

MatrixXd LmiBlock::change(const VectorXd& d) const {
  MatrixXd sum = MatrixXd::Zero(size(), size());
  if (!slopes.empty()) {
    for (int k = 0; k < count; ++k) sum += d(first + k) * slopes[static_cast<std::size_t>(k)];
    return sum;
  }
  int k = 0;
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j <= i && k < count; ++j, ++k) sum(i, j) = sum(j, i) = d(first + k);
  }
  return sum;
}

MatrixXd LmiBlock::at(const VectorXd& y) const { return constant + change(y); }

LmiSolution solveLmi(const LmiProgram& program, const VectorXd& start, double gap,
                     double stop_above) {
  LmiSolution solution;
  solution.y = start;
  for (const LmiBlock& block : program.blocks) {
    const MatrixXd S = block.at(start);
    const MatrixXd inverse = S.llt().solve(MatrixXd::Identity(S.rows(), S.cols()));
    solution.multipliers.push_back(0.5 * (inverse + inverse.transpose()));
  }
  const std::vector<StackedBlock> blocks(program.blocks.begin(), program.blocks.end());
  LmiPoint point(program, blocks);
  point.measure(solution);
  LmiSolution next = solution;
  while (solution.iterations < kMaxIterations) {
    if (!point.moveTo(solution)) break;
    ++solution.iterations;
    const double mu = point.mu();
    point.step(0.0, false);
    const double affine = point.muAfter(point.longestInY(1.0), point.longestInX(1.0));
    const double centring = std::pow(std::clamp(affine / mu, 1e-3, 1.0), 3);
    const VectorXd& dy = point.step(centring * mu, true);
    const double t_y = point.longestInY(0.98), t_x = point.longestInX(0.98);
    if (!dy.allFinite() || std::max(t_y, t_x) < 1e-6) break;
    next = solution;
    next.y += t_y * dy;
    for (std::size_t j = 0; j < next.multipliers.size(); ++j)
      next.multipliers[j] += t_x * point.changeOfX(j);
    point.measure(next);
    if (!std::isfinite(next.gap) || !(next.gap > 0.0)) break;
    std::swap(solution, next);
    solution.converged = solution.gap <= gap && solution.residual <= std::max(gap, 1e-12);
    if (solution.converged || program.reward.dot(solution.y) > stop_above) break;
  }
  return solution;
}

}  // namespace explore_opt
