/// The inner loops of the solvers ask the heap for nothing once they have begun: evaluations of the
/// programs Ipopt solves, iterations of the relaxations and of the barrier's descent.
#include <gtest/gtest.h>

#include "allocation_counter.hpp"
#include "barrier_descent.hpp"
#include "barrier_program.hpp"
#include "design_tools.hpp"
#include "factor_program.hpp"
#include "quad_support/linear_algebra.hpp"
#include "relaxation.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::thesisProblem;
using quad_support::testing::AllocationCounter;

namespace {

/// n = n_x n_φ unknown directions, as the thesis's problem (3), and larger ones.
std::vector<ExplorationProblem> problems() {
  ExplorationProblem full = thesisProblem(Phase::kCos);  // D of the full size: n = 6
  const MatrixXd m = randomMatrix(3, 0, 6, 6);
  full.D_des = 20.0 * (m * m.transpose() + MatrixXd::Identity(6, 6));
  ExplorationProblem large;  // n = 18, p = 12
  large.A = randomMatrix(1, 0, 3, 3);
  large.A *= 0.8 / large.A.norm();
  large.B = randomMatrix(1, 1, 3, 3);
  large.lines.num_samples = 400;
  large.lines.harmonics = {5, 47, 90, 132};
  large.gamma_w = 1.0;
  const MatrixXd d = randomMatrix(1, 2, 18, 18);
  large.D_des = d * d.transpose() / 18 + MatrixXd::Identity(18, 18);
  return {thesisProblem(Phase::kSin), full, large};
}

struct Scaled {
  explicit Scaled(const ExplorationProblem& problem)
      : task(taskOf(problem)),
        reference(task.onBoundary(randomDirection(task, 5, 0))),
        program(task.response, task.gamma_w, reference,
                {{0, -1, randomMatrix(91, 0, 2, task.response.numAmplitudes()),
                  randomMatrix(91, 1, 2, 1), 100.0}}),
        without_peaks(task.response, task.gamma_w, reference) {}
  DesignTask task;
  VectorXd reference;
  QuadraticProgram program, without_peaks;
};

/// Allocations of one evaluation of everything, after a first one.
long allocationsOf(SmoothProgram& program, const VectorXd& x) {
  VectorXd gradient(x.size()), c(program.numConstraints()),
      multipliers = VectorXd::Ones(program.numConstraints()),
      jacobian(static_cast<Eigen::Index>(program.jacobianPositions().size())),
      hessian(static_cast<Eigen::Index>(program.hessianPositions().size()));
  double f = 0.0;
  const auto evaluate = [&] {
    bool inside = program.objective(x, f);
    inside = program.gradient(x, gradient) && inside;
    program.constraints(x, c);
    program.jacobian(x, jacobian);
    return program.hessian(x, 1.0, multipliers, hessian) && inside;
  };
  EXPECT_TRUE(evaluate());
  const AllocationCounter counter;
  evaluate();
  return counter.count();
}

}  // namespace

class SolverMemory : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  }
};

TEST_F(SolverMemory, ProgramsOfIpoptEvaluateInWhatTheyHave) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem);
    const VectorXd a = s.program.toScaled(s.reference);
    FactorProgram factors(s.program);
    EXPECT_EQ(allocationsOf(factors, factors.startAt(a)), 0) << s.program.size();
    BarrierProgram barrier(s.without_peaks, a);
    EXPECT_EQ(allocationsOf(barrier, 1.01 * a), 0) << s.program.size();
  }
}

TEST_F(SolverMemory, MoreIterationsOfARelaxationAskForNoMore) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem);
    const LmiProgram programs[] = {dualProgram(s.without_peaks), liftedProgram(s.without_peaks)};
    const VectorXd starts[] = {dualStart(s.without_peaks),
                               liftedStart(s.without_peaks, s.without_peaks.toScaled(s.reference))};
    for (int k = 0; k < 2; ++k) {
      long counts[2];
      int iterations[2];
      for (int fine = 0; fine < 2; ++fine) {
        const AllocationCounter counter;
        iterations[fine] = solveLmi(programs[k], starts[k], fine == 0 ? 0.1 : 1e-9).iterations;
        counts[fine] = counter.count();
      }
      EXPECT_GE(iterations[1], iterations[0] + 3);
      EXPECT_EQ(counts[1], counts[0]) << "n = " << s.program.size() << ", program " << k;
    }
  }
}

TEST_F(SolverMemory, ALongerDescentOfTheBarrierAsksForNoMore) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem);
    const VectorXd start = 1.2 * s.program.toScaled(s.reference);
    long counts[2];
    for (int fine = 0; fine < 2; ++fine) {
      const AllocationCounter counter;
      ASSERT_GT(descendBarrier(s.program, start, fine == 0 ? 1e-2 : 1e-8).a.size(), 0);
      counts[fine] = counter.count();
    }
    EXPECT_EQ(counts[1], counts[0]) << s.program.size();
  }
}
