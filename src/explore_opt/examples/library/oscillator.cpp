/// A lightly damped oscillator: choose lines, design the experiment, fly it (here: simulate it with
/// a disturbance), identify, and see whether the promise was kept.
#include <cmath>
#include <cstdio>

#include "explore_opt/exploration_design.hpp"
#include "explore_opt/frequency_choice.hpp"
#include "explore_opt/identification.hpp"

using namespace explore_opt;

namespace {

/// The plant, which nobody knows: a little off the nominal model, and disturbed.
DataSet experiment(const Eigen::MatrixXd& U, double gamma_w) {
  const Eigen::Matrix2d A = (Eigen::Matrix2d() << 0.97, 0.20, -0.20, 0.97).finished();
  const Eigen::Vector2d B(0.01, 0.21);
  DataSet data{"flight", Eigen::MatrixXd::Zero(2, U.cols() + 1), U, gamma_w};
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    const Eigen::Vector2d w(0.02 * std::sin(0.9 * static_cast<double>(k)),
                            k % 2 == 0 ? 0.02 : -0.02);
    data.X.col(k + 1) = A * data.X.col(k) + B * U.col(k) + w;
  }
  return data;
}

}  // namespace

int main() {
  ExplorationProblem problem;
  problem.A = (Eigen::Matrix2d() << 0.98, 0.19, -0.19, 0.97).finished();
  problem.B = Eigen::Vector2d(0.0, 0.2);
  problem.lines = {500, {1}, {}};                          // T; the lines come below
  problem.gamma_w = 0.5;                                   // Σ‖w_k‖² will not exceed this
  problem.D_des = Eigen::MatrixXd::Constant(1, 1, 400.0);  // ‖error‖ <= 1/20, guaranteed

  problem.lines.harmonics = chooseFrequencies(problem).harmonics;
  const DesignResult design = designExploration(problem);
  if (!design.feasible()) return std::printf("%s\n", design.message.c_str()), 3;
  std::printf("amplitude %.4f, certified to %.1e\n", design.gamma_e, design.gap);

  const Eigen::MatrixXd U = multisine(problem.lines, problem.phase, 1.1 * design.amplitudes);
  IdentificationRequest request;
  request.closeness = problem.D_des;
  request.functions = {"B2/A12"};
  const Identification result = identify({experiment(U, problem.gamma_w)}, request);
  const std::string negative = complaint(result);
  if (!negative.empty()) return std::printf("%s\n", negative.c_str()), 3;
  const Interval gain = *result.functions.front();
  std::printf("promise kept; B2/A12 = %.4f lies in [%.4f, %.4f]\n", gain.value, gain.lower,
              gain.upper);
  return 0;
}
