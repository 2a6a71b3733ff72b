/// Gradients and Hessians against central differences.
#include <gtest/gtest.h>

#include "barrier_program.hpp"
#include "design_tools.hpp"
#include "dual_bound.hpp"
#include "factor_program.hpp"
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

/// A reference on the boundary and the scaled program around it.
struct Scaled {
  explicit Scaled(const ExplorationProblem& problem, std::uint64_t seed)
      : task{predictResponse(problem), problem.gamma_w, problem.numInputs()},
        reference(task.onBoundary(randomDirection(task, seed, 0))),
        program(task.response, task.gamma_w, reference) {}
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
  return {thesisProblem(Phase::kSin), thesisProblem(Phase::kCos), full, two};
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
    const MatrixXd original = s.program.toCertificate(Z);
    const double plain = original
                             .cwiseProduct(s.task.response.information(a) -
                                           s.task.gamma_w * MatrixXd::Identity(n, n))
                             .sum();
    EXPECT_NEAR(plain, hat * s.reference.squaredNorm(), 1e-9 * std::abs(plain));
    EXPECT_LT((s.program.fromCertificate(original) - Z).norm(), 1e-9 * Z.norm());
    EXPECT_NEAR(scaled.dot(s.program.H(Z) * scaled), Z.cwiseProduct(s.program.N(scaled)).sum(),
                1e-11 * Z.norm() * p);
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
      EXPECT_LT(c.norm(), 1e-9);
    }
    const int n = s.program.size();
    const MatrixXd Z0 = randomMatrix(1, 1, n, n), Z = Z0 + Z0.transpose();
    EXPECT_LT((program.certificateOf(program.multipliersOf(Z)) - Z).norm(), 1e-15 * Z.norm());
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

TEST(DualBarrier, Derivatives) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem, 31);
    const DualBarrier barrier(s.program);
    const int n = s.program.size(), m = barrier.numVariables();
    const double scale = 1.0 / (4.0 * s.program.H(MatrixXd::Identity(n, n)).norm());
    VectorXd z = VectorXd::Zero(m);
    for (int i = 0, k = 0; i < n; k += ++i) z(k + i) = scale;  // Z = scale I
    z += 0.05 * scale * randomMatrix(1, 5, m, 1);
    const double mu = 0.05;
    VectorXd gradient;
    MatrixXd root;
    barrier.gradientAndRoot(barrier.matrix(z), mu, gradient, root);
    const MatrixXd hessian = root.transpose() * root;
    for (int i = 0; i < m; ++i) {
      const double h = kStep * scale;  // Z is of that size
      const MatrixXd plus = barrier.matrix(z + h * VectorXd::Unit(m, i)),
                     minus = barrier.matrix(z - h * VectorXd::Unit(m, i));
      double above = 0.0, below = 0.0;
      ASSERT_TRUE(barrier.value(plus, mu, above) && barrier.value(minus, mu, below));
      EXPECT_NEAR(gradient(i), (above - below) / (2 * h), kTolerance * gradient.norm());
      VectorXd gradient_above, gradient_below;
      MatrixXd ignored;
      barrier.gradientAndRoot(plus, mu, gradient_above, ignored);
      barrier.gradientAndRoot(minus, mu, gradient_below, ignored);
      EXPECT_LT((hessian.col(i) - (gradient_above - gradient_below) / (2 * h)).norm(),
                kTolerance * hessian.norm());
    }
  }
}

TEST(DualSolution, PrimalAndDualMeet) {
  for (const ExplorationProblem& problem : problems()) {
    const Scaled s(problem, 41);
    const DualSolution dual = solveDual(s.program, 1e-6);
    const int n = s.program.size(), p = s.program.numAmplitudes();
    EXPECT_GT(explore_opt::testing::smallestEigenvalue(dual.Z), 0.0);
    const MatrixXd slack = MatrixXd::Identity(p, p) - 2.0 * s.program.H(dual.Z);
    EXPECT_GT(explore_opt::testing::smallestEigenvalue(slack), 0.0);
    // The lifted matrix satisfies Σ 𝒜_ab S_ab ⪰ R, and ½ tr 𝒜 - tr R Z = (n + p) μ. It is the
    // inverse of a slack of size 1e-7 known to 1e-15, so it has eight digits.
    MatrixXd lifted = MatrixXd::Zero(n, n);
    for (int a = 0; a < p; ++a) {
      for (int b = 0; b < p; ++b) lifted += dual.lifted(a, b) * s.program.S(a, b);
    }
    EXPECT_GE(explore_opt::testing::smallestEigenvalue(lifted - s.program.rightSide()),
              -1e-8);  // eight digits of 1
    const double gap = 0.5 * dual.lifted.trace() - s.program.rightSide().cwiseProduct(dual.Z).sum();
    EXPECT_NEAR(gap, dual.gap, 1e-8 * p);
    EXPECT_LE(dual.gap, 1.001e-6);
  }
}
