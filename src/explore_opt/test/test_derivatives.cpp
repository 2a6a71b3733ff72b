/// Gradients and Hessians against central differences.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "barrier_program.hpp"
#include "design_tools.hpp"
#include "factor_program.hpp"
#include "ipopt_solver.hpp"
#include "relaxation.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::thesisProblem;

namespace {

// Central differences err by h² f'''/6 + eps f/h, least at h = eps^(1/3) = 6e-6: about 4e-11 of the
// third derivatives, which are of order 1 to 100 in these coordinates. Second derivatives are
// differences of exact gradients.
constexpr double kStep = 6e-6;
constexpr double kTolerance = 1e-7;

MatrixXd denseFrom(const Positions& positions, const VectorXd& values, int rows, int cols,
                   bool symmetric) {
  EXPECT_EQ(positions.size(), static_cast<std::size_t>(values.size()));
  MatrixXd dense = MatrixXd::Zero(rows, cols);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto [r, c] = positions[i];
    dense(r, c) += values(static_cast<Eigen::Index>(i));
    if (symmetric && r != c) dense(c, r) += values(static_cast<Eigen::Index>(i));
  }
  return dense;
}

/// Gradient of weight f + λᵀ c at x.
VectorXd lagrangianGradient(SmoothProgram& program, const VectorXd& x, double weight,
                            const VectorXd& lambda) {
  VectorXd g(x.size());
  EXPECT_TRUE(program.gradient(x, g));
  g *= weight;
  const Positions positions = program.jacobianPositions();
  VectorXd values(positions.size());
  program.jacobian(x, values);
  return g +
         denseFrom(positions, values, program.numConstraints(), static_cast<int>(x.size()), false)
                 .transpose() *
             lambda;
}

double lagrangian(SmoothProgram& program, const VectorXd& x, double weight,
                  const VectorXd& lambda) {
  double f = 0.0;
  EXPECT_TRUE(program.objective(x, f));
  VectorXd c(program.numConstraints());
  program.constraints(x, c);
  return weight * f + lambda.dot(c);
}

void checkDerivatives(SmoothProgram& program, const VectorXd& x, double weight,
                      const VectorXd& lambda) {
  const VectorXd gradient = lagrangianGradient(program, x, weight, lambda);
  const Positions positions = program.hessianPositions();
  for (const auto& [r, c] : positions) EXPECT_GE(r, c);  // lower triangle
  VectorXd values(positions.size());
  ASSERT_TRUE(program.hessian(x, weight, lambda, values));
  const int n = static_cast<int>(x.size());
  const MatrixXd hessian = denseFrom(positions, values, n, n, true);
  for (int i = 0; i < n; ++i) {
    const VectorXd plus = x + kStep * VectorXd::Unit(n, i),
                   minus = x - kStep * VectorXd::Unit(n, i);
    const double slope =
        (lagrangian(program, plus, weight, lambda) - lagrangian(program, minus, weight, lambda)) /
        (2 * kStep);
    EXPECT_NEAR(gradient(i), slope, kTolerance * (1.0 + gradient.norm())) << "gradient " << i;
    const VectorXd column = (lagrangianGradient(program, plus, weight, lambda) -
                             lagrangianGradient(program, minus, weight, lambda)) /
                            (2 * kStep);
    EXPECT_LT((hessian.col(i) - column).norm(), kTolerance * (1.0 + hessian.norm()))
        << "Hessian " << i;
  }
}

/// One limit on the norm of two numbers and one on a single one.
std::vector<PeakConstraint> somePeaks(const DesignTask& task) {
  const int p = task.response.numAmplitudes();
  return {{0, -1, randomMatrix(91, 0, 2, p), randomMatrix(91, 1, 2, 1), 30.0},
          {3, 0, randomMatrix(92, 0, 1, p), VectorXd::Zero(1), 40.0}};
}

/// A reference on the boundary and the scaled program around it.
struct Scaled {
  Scaled(const ExplorationProblem& problem, std::uint64_t seed, bool peaks = true)
      : task(taskOf(problem)),
        reference(task.onBoundary(randomDirection(task, seed, 0))),
        program(task.response, task.gamma_w, reference,
                peaks ? somePeaks(task) : std::vector<PeakConstraint>()) {}
  DesignTask task;
  VectorXd reference;
  QuadraticProgram program;
};

std::vector<ExplorationProblem> problems() {
  ExplorationProblem full = thesisProblem(Phase::kCos);  // D of the full size: n = 6
  const MatrixXd m = randomMatrix(3, 0, 6, 6);
  full.D_des = 20.0 * (m * m.transpose() + MatrixXd::Identity(6, 6));
  ExplorationProblem two = thesisProblem(Phase::kBoth, 60);
  two.A = (MatrixXd(2, 2) << 0.8, 0.2, -0.1, 0.7).finished();
  two.B = MatrixXd::Identity(2, 2);
  ExplorationProblem start = thesisProblem(Phase::kCos);
  start.x0 = Eigen::Vector2d(3.0, -1.0);
  ExplorationProblem known = thesisProblem(Phase::kSin);
  known.known = MatrixXd::Constant(2, 3, NAN);
  known.known(0, 0) = known.known(1, 1) = 1.0;
  known.known(1, 0) = 0.0;
  return {thesisProblem(Phase::kSin), thesisProblem(Phase::kCos), full, two, start, known};
}

}  // namespace

TEST(QuadraticProgram, IsTheSameProblemInOtherCoordinates) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem, 5);
    const VectorXd a = randomDirection(s.task, 5, 1);
    const int p = s.program.numAmplitudes(), n = s.program.size();
    const MatrixXd Z0 = randomMatrix(1, 1, n, n), Z = Z0 * Z0.transpose();
    const VectorXd scaled = s.program.toScaled(a);
    EXPECT_LT((s.program.toAmplitudes(scaled) - a).norm(), 1e-14 * a.norm());
    // tr Ẑ(N̂ - R̂) · s² = tr Z (N - γ_w I): the Lagrangian is the same number. Congruences of
    // condition 1e3 round.
    const double hat = Z.cwiseProduct(s.program.N(scaled) - s.program.rightSide()).sum();
    const MatrixXd root = s.program.toRoot(Z), original = root * root.transpose();
    const double plain = original
                             .cwiseProduct(s.task.response.information(a) -
                                           s.task.gamma_w * MatrixXd::Identity(n, n))
                             .sum();
    EXPECT_NEAR(plain, hat * s.reference.squaredNorm(), 1e-9 * std::abs(plain));
    EXPECT_LT((s.program.fromRoot(root) - Z).norm(), 1e-9 * Z.norm());
    if (s.program.homogeneous()) {
      EXPECT_NEAR(scaled.dot(s.program.H(Z) * scaled), Z.cwiseProduct(s.program.N(scaled)).sum(),
                  1e-11 * Z.norm() * p);
    }
    // The reference has unit cost, sits on the boundary, and its slack is diagonal.
    MatrixXd slack = s.program.N(s.program.toScaled(s.reference)) - s.program.rightSide();
    EXPECT_NEAR(slack(n - 1, n - 1), 0.0, 1e-10);
    slack.diagonal().setZero();
    EXPECT_LT(slack.norm(), 1e-10);
  }
}

TEST(FactorProgram, Derivatives) {
  std::uint64_t seed = 0;
  for (const ExplorationProblem& problem : problems()) {
    SCOPED_TRACE(seed);
    const Scaled s(problem, ++seed);
    FactorProgram program(s.program);
    const VectorXd x = randomMatrix(seed, 2, program.numVariables(), 1);
    checkDerivatives(program, x, 0.7, randomMatrix(seed, 3, program.numConstraints(), 1));
  }
}

TEST(FactorProgram, StartSatisfiesTheConstraints) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem, 4);
    const FactorProgram program(s.program);
    FactorProgram constraints(s.program);
    for (const double margin : {0.0, 0.2}) {
      const VectorXd x = program.startAt((1.0 + margin) * s.program.toScaled(s.reference));
      VectorXd c(program.numConstraints());
      constraints.constraints(x, c);
      const int peaks = program.numInequalities();
      ASSERT_EQ(peaks, 2);
      EXPECT_LT(c.head(c.size() - peaks).norm(), 1e-9);
      for (int k = 0; k < peaks; ++k) {
        const PeakConstraint& peak = s.program.peaks()[static_cast<std::size_t>(k)];
        EXPECT_EQ(c(c.size() - peaks + k), peak.room(program.amplitudesOf(x)));
      }
    }
    const int n = s.program.size();
    const MatrixXd Z0 = randomMatrix(1, 1, n, n), Z = Z0 + Z0.transpose();
    EXPECT_LT((program.certificateOf(program.multipliersOf(Z, VectorXd::Ones(2))) - Z).norm(),
              1e-15 * Z.norm());
  }
}

TEST(BarrierProgram, Derivatives) {
  std::uint64_t seed = 10;
  for (const ExplorationProblem& problem : problems()) {
    SCOPED_TRACE(seed);
    const Scaled s(problem, ++seed);
    const VectorXd candidate = s.program.toScaled(s.reference);
    BarrierProgram program(s.program, candidate);
    program.setWeight(0.03);
    const VectorXd a =
        1.4 * candidate + 0.01 * randomMatrix(seed, 4, static_cast<int>(candidate.size()), 1);
    checkDerivatives(program, a, 1.3, VectorXd());
  }
}

TEST(BarrierProgram, RelaxationLiesBelowAndTouches) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem, 21);
    const VectorXd candidate = s.program.toScaled(s.reference);
    const BarrierProgram program(s.program, candidate);
    EXPECT_LT((program.slack(candidate) - (s.program.N(candidate) - s.program.rightSide())).norm(),
              1e-12);
    for (std::uint64_t i = 0; i < 20; ++i) {
      const VectorXd a = randomDirection(s.task, 22, i);
      const MatrixXd above = s.program.N(a) - s.program.rightSide() - program.slack(a);
      EXPECT_GE(explore_opt::testing::smallestEigenvalue(above), -1e-12 * above.norm());
    }
  }
}

TEST(BarrierProgram, OutsideTheConeThereIsNoValue) {
  const Scaled s(thesisProblem(Phase::kCos), 1);
  BarrierProgram program(s.program, s.program.toScaled(s.reference));
  const VectorXd outside = 0.3 * s.program.toScaled(s.reference);
  double f = 0.0;
  VectorXd g(4), h(10);
  EXPECT_FALSE(program.objective(outside, f));
  EXPECT_FALSE(program.gradient(outside, g));
  EXPECT_FALSE(program.hessian(outside, 1.0, VectorXd(), h));
}

TEST(Relaxation, BothProgramsMeet) {
  int orders = 0;
  for (const ExplorationProblem& problem : problems()) {
    SCOPED_TRACE(orders++);
    const Scaled s(problem, 41, false);
    const int n = s.program.size(), p = s.program.numAmplitudes();
    const LmiProgram dual = dualProgram(s.program), lifted = liftedProgram(s.program);
    const LmiSolution below = solveLmi(dual, dualStart(s.program), 1e-9);
    const LmiSolution above =
        solveLmi(lifted, liftedStart(s.program, s.program.toScaled(s.reference)), 1e-9);
    EXPECT_TRUE(below.converged);
    EXPECT_TRUE(above.converged);
    // Either value is that of a strictly feasible point, so they enclose the optimum.
    const double low = dual.reward.dot(below.y), high = -lifted.reward.dot(above.y);
    EXPECT_LE(low, high);
    EXPECT_LE(high - low, 2.1e-9);
    EXPECT_GT(explore_opt::testing::smallestEigenvalue(dual.blocks[0].at(below.y)), 0.0);
    EXPECT_GT(explore_opt::testing::smallestEigenvalue(dual.blocks[1].at(below.y)), 0.0);

    const RelaxedSolution relaxed = solveRelaxed(s.program, s.program.toScaled(s.reference), 1e-9);
    MatrixXd N = s.program.homogeneous() ? MatrixXd::Zero(n, n) : s.program.S_00();
    for (int a = 0; a < p; ++a) {
      if (!s.program.homogeneous()) N += 2.0 * relaxed.mean(a) * s.program.S_0(a);
      for (int b = 0; b < p; ++b) N += relaxed.lifted(a, b) * s.program.S(a, b);
    }
    // A multiplier is feasible up to the solver's residual, asked for to 1e-9.
    EXPECT_GE(explore_opt::testing::smallestEigenvalue(N - s.program.rightSide()), -1e-8);
    EXPECT_NEAR(0.5 * relaxed.lifted.trace(), high, 1e-8);
  }
}

TEST(Relaxation, ThePeakLimitHasItsShare) {  // u_max as one more row: the bound rises, and holds
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  DesignTask task = taskOf(problem);
  const VectorXd start = task.onBoundary(VectorXd::Ones(4));
  PeakConstraint first;  // at k = 0 all cosines are 1
  first.rows = MatrixXd::Ones(1, 4);
  first.offset = VectorXd::Zero(1);
  first.limit = 4.5;
  task.peaks = {first};
  const QuadraticProgram program(task.response, task.gamma_w, start, task.peaks);
  const RelaxedSolution relaxed = solveRelaxed(program, program.toScaled(start), 1e-9);
  ASSERT_TRUE(relaxed.converged);
  EXPECT_GT(relaxed.nu(0), 1e-3);  // 5.7 without it
  const Certificate bound =
      task.certify(program.toRoot(relaxed.Z), program.toCost(1.0) * relaxed.nu);
  EXPECT_GT(bound.bound, 3.3194);
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const VectorXd a = task.onBoundary(randomDirection(task, 7, seed));
    if (first.room(a) >= 0.0) {
      EXPECT_GE(a.norm(), bound.bound) << seed;
    }
  }
}

TEST(LmiSolver, SmallestEigenvalue) {  // max t s.t. M - t I ⪰ 0
  const MatrixXd m = randomMatrix(3, 9, 7, 7), M = m + m.transpose();
  LmiProgram program;
  program.reward = VectorXd::Ones(1);
  program.blocks.push_back({M, 0, 1, {-MatrixXd::Identity(7, 7)}});
  const LmiSolution solution = solveLmi(program, VectorXd::Constant(1, -2.0 * M.norm()), 1e-10);
  EXPECT_TRUE(solution.converged);
  EXPECT_NEAR(solution.y(0), explore_opt::testing::smallestEigenvalue(M), 1e-9);
  EXPECT_NEAR(solution.multipliers[0].trace(), 1.0, 1e-9);
}

TEST(LmiSolver, StopsWhereThereIsNoMaximum) {  // max t s.t. I + t I ⪰ 0
  LmiProgram program;
  program.reward = VectorXd::Ones(1);
  program.blocks.push_back({MatrixXd::Identity(2, 2), 0, 1, {MatrixXd::Identity(2, 2)}});
  const LmiSolution solution = solveLmi(program, VectorXd::Zero(1), 1e-9, 50.0);
  EXPECT_FALSE(solution.converged);
  EXPECT_GT(solution.y(0), 50.0);
}

namespace {

/// min ½‖x‖² s.t. x_0 x_1 = 1, whose slope is not finite where x_0 = 0.
class BrokenAtZero : public SmoothProgram {
 public:
  int numVariables() const override { return 2; }
  int numConstraints() const override { return 1; }
  bool objective(const VectorXd& x, double& f) override {
    f = 0.5 * x.squaredNorm();
    return true;
  }
  bool gradient(const VectorXd& x, VectorXd& g) override {
    g = x;
    return true;
  }
  void constraints(const VectorXd& x, VectorXd& c) override { c(0) = x(0) * x(1) - 1.0; }
  Positions jacobianPositions() const override { return {{0, 0}, {0, 1}}; }
  void jacobian(const VectorXd& x, VectorXd& values) override {
    values(0) = x(0) == 0.0 ? std::numeric_limits<double>::quiet_NaN() : x(1);
    values(1) = x(0) == 0.0 ? std::numeric_limits<double>::infinity() : x(0);
  }
  Positions hessianPositions() const override { return {{0, 0}, {1, 0}, {1, 1}}; }
  bool hessian(const VectorXd&, double weight, const VectorXd& lambda, VectorXd& values) override {
    values << weight, lambda(0), weight;
    return true;
  }
};

}  // namespace

// MUMPS, behind Ipopt, ends the process on such a Jacobian.
TEST(IpoptSolver, NumbersThatAreNotFiniteEndInAFailure) {
  BrokenAtZero program;
  IpoptSolver solver(1e-9, 50);
  EXPECT_EQ(solver.solve(program, {Eigen::Vector2d(0.0, 2.0), {}}).status, SolverStatus::kFailed);
  EXPECT_EQ(solver.solve(program, {Eigen::Vector2d(NAN, 2.0), {}}).status, SolverStatus::kFailed);
  const SolverAnswer answer = solver.solve(program, {Eigen::Vector2d(2.0, 1.0), {}});
  EXPECT_EQ(answer.status, SolverStatus::kConverged);
  EXPECT_NEAR(answer.x(0), 1.0, 1e-6);
}
