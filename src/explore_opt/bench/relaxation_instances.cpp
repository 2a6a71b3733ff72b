/// Writes relaxations of design problems as SDPA files and tells how long our solver takes for
/// each, one JSON object a line, for scripts/bench_solvers to set beside other solvers.
/// usage: relaxation_instances DIRECTORY
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "../test/sdpa.hpp"
#include "../test/thesis_problem.hpp"
#include "design_tools.hpp"
#include "relaxation.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::thesisProblem;

namespace {

/// n_x states, n_u inputs, L lines; D_des a random full matrix (size n_x n_φ) or λ I (size n_φ).
ExplorationProblem randomProblem(int nx, int nu, int L, bool full) {
  ExplorationProblem problem;
  problem.A = randomMatrix(1, 0, nx, nx);
  problem.A *= 0.8 / problem.A.norm();
  problem.B = randomMatrix(1, 1, nx, nu);
  problem.lines.num_samples = 400;
  for (int i = 0; i < L; ++i) problem.lines.harmonics.push_back(5 + 170 * i / L);
  problem.gamma_w = 1.0;
  problem.D_des = MatrixXd::Constant(1, 1, 10.0);
  if (full) {
    const int n = nx * (nx + nu);
    const MatrixXd m = randomMatrix(1, 2, n, n);
    problem.D_des = m * m.transpose() / n + MatrixXd::Identity(n, n);
    problem.D_des = 0.5 * (problem.D_des + problem.D_des.transpose()).eval();
  }
  return problem;
}

void run(const std::string& name, const ExplorationProblem& problem, const std::string& directory) {
  const DesignTask task = taskOf(problem);
  const VectorXd start = *cheapestSimpleDirection(task, 1);
  const QuadraticProgram program(task.response, task.gamma_w, start);
  const VectorXd reference = program.toScaled(start);
  const int n = program.size(), p = program.numAmplitudes();
  const bool lift = p * (p + 1) < n * (n + 1);  // the choice solveRelaxed() makes
  const LmiProgram lmi = lift ? liftedProgram(program) : dualProgram(program);
  const VectorXd y = lift ? liftedStart(program, reference) : dualStart(program);
  std::vector<double> milliseconds;
  LmiSolution solution;
  for (int i = 0; i < 21; ++i) {
    const std::clock_t begin = std::clock();  // processor time: other work disturbs it less
    for (int k = 0; k < 5; ++k) solution = solveLmi(lmi, y, 1e-8);
    milliseconds.push_back(0.2e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::string file = directory + "/" + name + ".dat-s";
  explore_opt::testing::writeSdpa(lmi, file);
  fmt::print(
      "{{\"name\": \"{}\", \"file\": \"{}\", \"n\": {}, \"p\": {}, \"unknowns\": {}, "
      "\"milliseconds\": {:.4f}, \"iterations\": {}, \"value\": {:.12g}, \"converged\": {}}}\n",
      name, file, n, p, lmi.reward.size(), milliseconds[milliseconds.size() / 2],
      solution.iterations, -lmi.reward.dot(solution.y), solution.converged);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: relaxation_instances DIRECTORY\n");
    return 2;
  }
  run("thesis", thesisProblem(Phase::kSin), argv[1]);
  run("n18_L4", randomProblem(3, 3, 4, true), argv[1]);
  run("n11_L8", randomProblem(8, 3, 8, false), argv[1]);
  return 0;
}
