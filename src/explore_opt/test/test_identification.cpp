#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "explore_opt/least_squares.hpp"
#include "explore_opt/set_membership.hpp"
#include "explore_opt/structured_least_squares.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using explore_opt::testing::kroneckerIdentity;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::smallestEigenvalue;
using quad_support::DataError;

namespace {

/// A stable random system driven by a random input and a disturbance of a given energy.
struct Experiment {
  Eigen::MatrixXd Theta, X, U;

  Experiment(std::uint64_t seed, double energy, int nx = 2, int nu = 1, int T = 60) {
    Theta = 0.3 * randomMatrix(seed, 0, nx, nx + nu);
    U = randomMatrix(seed, 1, nu, T);
    Eigen::MatrixXd w = randomMatrix(seed, 2, nx, T);
    w *= std::sqrt(energy / w.squaredNorm());
    X = Eigen::MatrixXd::Zero(nx, T + 1);
    for (int k = 0; k < T; ++k) X.col(k + 1) = Theta * phi(k) + w.col(k);
  }
  Eigen::VectorXd phi(int k) const {
    return (Eigen::VectorXd(X.rows() + U.rows()) << X.col(k), U.col(k)).finished();
  }
  Eigen::MatrixXd regressor() const {
    Eigen::MatrixXd all(X.rows() + U.rows(), U.cols());
    for (int k = 0; k < U.cols(); ++k) all.col(k) = phi(k);
    return all;
  }
};

Eigen::MatrixXd scalar(double value) { return Eigen::MatrixXd::Constant(1, 1, value); }

Eigen::MatrixXd spd(std::uint64_t seed, int n) {
  const Eigen::MatrixXd m = randomMatrix(seed, 9, n, n);
  return m * m.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
}

}  // namespace

TEST(LeastSquares, ByHand) {
  // x: 1, 2, 3; u: 1, -1. Two equations, two unknowns: 2 = a + b, 3 = 2 a - b, so a = 5/3, b = 1/3.
  const LeastSquaresFit fit = fitLeastSquares((Eigen::MatrixXd(1, 3) << 1, 2, 3).finished(),
                                              (Eigen::MatrixXd(1, 2) << 1, -1).finished());
  ASSERT_TRUE(fit.exciting);
  EXPECT_NEAR(fit.Theta(0, 0), 5.0 / 3.0, 1e-14);  // a dozen roundings
  EXPECT_NEAR(fit.Theta(0, 1), 1.0 / 3.0, 1e-14);
  EXPECT_LT(fit.residual_energy, 1e-29);
  EXPECT_EQ(fit.information, (Eigen::MatrixXd(2, 2) << 5, -1, -1, 2).finished());
}

TEST(LeastSquares, ResidualIsOrthogonalToTheRegressor) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Experiment data(seed, 1.0, 1 + static_cast<int>(seed % 3),
                          1 + static_cast<int>(seed % 2));
    const LeastSquaresFit fit = fitLeastSquares(data.X, data.U);
    ASSERT_TRUE(fit.exciting);
    const Eigen::MatrixXd phi = data.regressor();
    EXPECT_LT((fit.residual * phi.transpose()).norm(),
              1e-12 * phi.norm());  // 60 products of rounded numbers
    EXPECT_LT((fit.root.transpose() * fit.root - fit.information).norm(),
              1e-13 * fit.information.norm());
  }
}

TEST(LeastSquares, KeepsItsDigitsFarFromTheOrigin) {
  // A falling vehicle: positions of 5000 with noise-free steps. Normal equations would lose 1e9 ·
  // 1e-16 here.
  const LinearSystem truth = altitudeModel(0.73, 0.1, 0.0);
  Eigen::MatrixXd X(2, 371), U = randomMatrix(3, 0, 1, 370);
  X.col(0) << 5000.0, 0.0;
  for (int k = 0; k < 370; ++k) X.col(k + 1) = truth.A * X.col(k) + truth.B * U.col(k);
  const LeastSquaresFit fit = fitLeastSquares(X, U);
  ASSERT_TRUE(fit.exciting);
  // Positions are rounded to 5e-13 a sample, velocities vary by about 1 over 370 samples.
  EXPECT_LT((fit.Theta.leftCols(2) - truth.A).norm(), 1e-11);
  EXPECT_LT((fit.Theta.rightCols(1) - truth.B).norm(), 1e-11);
}

TEST(LeastSquares, SaysWhenDataDoNotExcite) {
  const Experiment data(1, 0.1);
  const LeastSquaresFit still = fitLeastSquares(data.X, Eigen::MatrixXd::Zero(1, data.U.cols()));
  EXPECT_FALSE(still.exciting);
  EXPECT_EQ(still.singular_values.size(), 3);
  EXPECT_LT(still.singular_values(2), 1e-12);
  Eigen::MatrixXd twice(2, data.U.cols());
  twice << data.U, 3.0 * data.U;  // the same input on two channels
  EXPECT_FALSE(fitLeastSquares(data.X, twice).exciting);
  EXPECT_THROW(feasibleSet(still, 1.0), DataError);
}

TEST(LeastSquares, RefusesBrokenData) {
  const Experiment data(1, 0.1);
  EXPECT_THROW(fitLeastSquares(data.X.leftCols(60), data.U), DataError);
  EXPECT_THROW(fitLeastSquares(data.X.leftCols(3), data.U.leftCols(2)), DataError);  // T = 2 < 3
  Eigen::MatrixXd X = data.X;
  X(1, 7) = NAN;
  EXPECT_THROW(fitLeastSquares(X, data.U), DataError);
}

TEST(SetMembership, ThreeFormsOfG) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Experiment data(seed, 1.0);
    const double gamma_w = 3.0;
    const LeastSquaresFit fit = fitLeastSquares(data.X, data.U);
    const Eigen::MatrixXd phi = data.regressor(), S = phi * phi.transpose();
    const Eigen::MatrixXd next = data.X.rightCols(data.U.cols());
    const Eigen::VectorXd theta =
        Eigen::Map<const Eigen::VectorXd>(fit.Theta.data(), fit.Theta.size());
    const Eigen::VectorXd X = Eigen::Map<const Eigen::VectorXd>(next.data(), next.size());
    const double printed =
        gamma_w + theta.dot(kroneckerIdentity(S, 2) * theta) - X.squaredNorm();  // Eq. (1.8)
    const Eigen::MatrixXd projector = phi.transpose() * S.inverse() * phi;
    const double section32 = gamma_w - X.squaredNorm() + X.dot(kroneckerIdentity(projector, 2) * X);
    const double G = feasibleSet(fit, gamma_w).G;
    EXPECT_NEAR(G, printed,
                1e-12 * (gamma_w + X.squaredNorm()));  // rounding of the numbers subtracted
    EXPECT_NEAR(G, section32, 1e-12 * (gamma_w + X.squaredNorm()));
  }
}

TEST(SetMembership, TruthIsAsFarInsideAsTheBoundWasLoose) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {  // ‖θ_tr - θ̂‖² - G = ‖w‖² - γ_w
    SCOPED_TRACE(seed);
    for (const double energy : {0.5, 1.0, 1.5}) {
      const Experiment data(seed, energy);
      const FeasibleSet set = feasibleSet(fitLeastSquares(data.X, data.U), 1.0);
      EXPECT_NEAR(distance(set, data.Theta) - set.G, energy - 1.0,
                  1e-11);           // energies of order 100 are rounded
      if (energy == 1.0) continue;  // on the boundary: rounding decides
      EXPECT_EQ(contains(set, data.Theta), energy < 1.0);
    }
  }
}

TEST(SetMembership, FalsifiedSetIsEmpty) {
  const Experiment data(5, 10.0);
  const LeastSquaresFit fit = fitLeastSquares(data.X, data.U);
  const FeasibleSet set = feasibleSet(fit, 0.5 * fit.residual_energy);
  EXPECT_TRUE(set.falsified());
  EXPECT_FALSE(set.lambdaBound().has_value());
  EXPECT_FALSE(contains(set, fit.Theta));
  EXPECT_FALSE(explorationCondition(set, scalar(1e-9)));
  EXPECT_THROW(feasibleSet(fit, 0.0), DataError);
  EXPECT_THROW(feasibleSet(fit, NAN), DataError);
}

TEST(SetMembership, ScalarConditionIsLambdaMin) {
  const Experiment data(6, 1.0);
  const LeastSquaresFit fit = fitLeastSquares(data.X, data.U);
  const FeasibleSet set = feasibleSet(fit, 2.0);
  const double lambda = smallestEigenvalue(fit.information);
  EXPECT_NEAR(set.lambda_min_S, lambda, 1e-12 * fit.information.norm());
  EXPECT_NEAR(*set.lambdaBound(), lambda / set.G, 1e-10 * lambda);
  EXPECT_TRUE(explorationCondition(set, scalar(0.999 * *set.lambdaBound())));
  EXPECT_FALSE(explorationCondition(set, scalar(1.001 * *set.lambdaBound())));
}

TEST(SetMembership, MarginIsTheEigenvalueOfTheNormalisedInformation) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    const Experiment data(seed, 1.0);
    const LeastSquaresFit fit = fitLeastSquares(data.X, data.U);
    const FeasibleSet set = feasibleSet(fit, 2.0);
    for (const Eigen::MatrixXd& D : {spd(seed, 3), spd(seed, 6)}) {
      const Eigen::MatrixXd full = fullCloseness(D, 2, 3);
      const Eigen::MatrixXd root =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full).operatorInverseSqrt();
      const double expected =
          smallestEigenvalue(root * kroneckerIdentity(fit.information, 2) * root);
      EXPECT_NEAR(informationMargin(set, D), expected, 1e-9 * expected);
    }
    EXPECT_NEAR(informationMargin(set, scalar(4.0)),
                informationMargin(set, 4.0 * Eigen::MatrixXd::Identity(6, 6)),
                1e-9 * set.lambda_min_S);
  }
}

TEST(SetMembership, SingularClosenessIsAllowed) {
  const Experiment data(8, 1.0);
  const LeastSquaresFit fit = fitLeastSquares(data.X, data.U);
  const FeasibleSet set = feasibleSet(fit, 2.0);
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(3, 3);
  D(2, 2) = 5.0;  // only the input's column matters: G D ⪯ S iff G · 5 <= 1/(S⁻¹)_33
  EXPECT_NEAR(informationMargin(set, D), 1.0 / (5.0 * fit.information.inverse()(2, 2)),
              1e-9 * set.lambda_min_S);
  EXPECT_TRUE(explorationCondition(set, Eigen::MatrixXd::Zero(3, 3)));
}

TEST(SetMembership, ConditionImpliesTheObjective) {
  int met = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {  // (1.10) and a valid γ_w imply (1.9)
    const Experiment data(seed, 0.9);
    const FeasibleSet set = feasibleSet(fitLeastSquares(data.X, data.U), 1.0);
    const Eigen::MatrixXd D = *set.lambdaBound() * 0.999 * Eigen::MatrixXd::Identity(3, 3);
    ASSERT_TRUE(explorationCondition(set, D));
    ASSERT_LE(explorationObjective(data.Theta, set.center, D), 1.0) << seed;
    ++met;
  }
  EXPECT_EQ(met, 200);
}

TEST(SetMembership, ChainOfClosenessMatrices) {
  const Experiment data(9, 0.5);
  const FeasibleSet set = feasibleSet(fitLeastSquares(data.X, data.U), 1.0);
  const double bound = *set.lambdaBound();
  EXPECT_TRUE(judgeChain(set, data.Theta, scalar(0.5 * bound), scalar(0.1 * bound)).holds());
  const ClosenessChain much = judgeChain(set, data.Theta, scalar(2.0 * bound), scalar(0.1 * bound));
  EXPECT_TRUE(much.truth_within_bound && !much.bound_within_desired && much.desired_within_initial);
  const ClosenessChain little =
      judgeChain(set, data.Theta, scalar(0.05 * bound), scalar(0.1 * bound));
  EXPECT_TRUE(little.truth_within_bound && little.bound_within_desired &&
              !little.desired_within_initial);
  const ClosenessChain far =
      judgeChain(set, data.Theta.array() + 10.0, scalar(0.5 * bound), scalar(0.1 * bound));
  EXPECT_FALSE(far.truth_within_bound);
}

TEST(SetMembership, RandomRunOfTheThesisIsConsistent) {
  // Section 3.3.3 prints the estimate; 0.5727 and 174.6 follow from it. Entries are printed to four
  // digits.
  Eigen::MatrixXd truth(2, 3), estimate(2, 3);
  const LinearSystem model = altitudeModel(0.73, 0.1, 0.0);
  truth << model.A, model.B;
  estimate << 1, 0.10003, 0.01219, -2.685e-5, 1.001, 0.0615;
  EXPECT_NEAR(explorationObjective(truth, estimate, scalar(100.0)), 0.5727,
              100 * 2 * 0.0757 * 6e-5);
  EXPECT_NEAR(closenessOfFit(truth, estimate), 174.6, 174.6 * 2 * 6e-5 / 0.0757);
  EXPECT_NEAR(std::sqrt(1.0 / closenessOfFit(truth, estimate)), 0.0757, 6e-5 + 1e-5);
}

TEST(SetMembership, RefusesWrongCloseness) {
  EXPECT_THROW(fullCloseness(Eigen::MatrixXd::Identity(4, 4), 2, 3), DataError);
  EXPECT_THROW(fullCloseness((Eigen::MatrixXd(3, 3) << 1, 2, 0, 0, 1, 0, 0, 0, 1).finished(), 2, 3),
               DataError);
  EXPECT_THROW(fullCloseness(Eigen::MatrixXd::Identity(2, 3), 2, 3), DataError);
}

TEST(SetMembership, RefusesAnIndefiniteCloseness) {
  const Experiment data(8, 1.0);
  const FeasibleSet set = feasibleSet(fitLeastSquares(data.X, data.U), 2.0);
  EXPECT_THROW(explorationCondition(set, scalar(-1.0)), std::invalid_argument);
  EXPECT_THROW(explorationCondition(set, Eigen::Vector3d(1, 1, -1e-3).asDiagonal()),
               std::invalid_argument);
}

TEST(StructuredFit, WithNothingKnownItIsTheOrdinaryFit) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Experiment data(seed, 1.0);
    const LeastSquaresFit plain = fitLeastSquares(data.X, data.U);
    const StructuredFit fit = fitStructured(data.X, data.U, Eigen::MatrixXd::Constant(2, 3, NAN));
    ASSERT_TRUE(fit.exciting);
    EXPECT_LT((fit.Theta - plain.Theta).norm(), 1e-12);
    EXPECT_NEAR(fit.residual_energy, plain.residual_energy, 1e-12);
    EXPECT_LT((fit.information - kroneckerIdentity(plain.information, 2)).norm(),
              1e-12 * plain.information.norm());
  }
}

TEST(StructuredFit, KnownEntriesStayAndTheRestSolvesItsNormalEquations) {
  const Experiment data(4, 1.0);
  Eigen::MatrixXd known = Eigen::MatrixXd::Constant(2, 3, NAN);
  known(0, 0) = data.Theta(0, 0);
  known(1, 0) = data.Theta(1, 0);
  known(1, 1) = data.Theta(1, 1);
  const StructuredFit fit = fitStructured(data.X, data.U, known);
  ASSERT_TRUE(fit.exciting);
  ASSERT_EQ(fit.free.size(), 3u);  // A12, B1, B2: by columns
  EXPECT_EQ(fit.free[0].row, 0);
  EXPECT_EQ(fit.free[0].column, 1);
  EXPECT_EQ(fit.free[2].row, 1);
  EXPECT_EQ(fit.free[2].column, 2);
  EXPECT_EQ(fit.Theta(1, 1), known(1, 1));
  const Eigen::MatrixXd phi = data.regressor();
  const Eigen::MatrixXd gradient = (data.X.rightCols(60) - fit.Theta * phi) * phi.transpose();
  for (const Entry& entry : fit.free) EXPECT_LT(std::abs(gradient(entry.row, entry.column)), 1e-11);
  const Eigen::MatrixXd S = phi * phi.transpose();
  EXPECT_NEAR(fit.information(1, 0), S(1, 2), 1e-11);  // A12 and B1 share a row of Θ
  EXPECT_NEAR(fit.information(2, 1), 0.0, 1e-11);      // B1 and B2 do not
  EXPECT_NEAR(fit.information(2, 2), S(2, 2), 1e-11);
}

TEST(StructuredFit, RestrictsTheCloseness) {
  const Experiment data(4, 1.0);
  Eigen::MatrixXd known = Eigen::MatrixXd::Zero(2, 3);
  known(0, 1) = known(1, 2) = NAN;
  const StructuredFit fit = fitStructured(data.X, data.U, known);
  Eigen::MatrixXd D = Eigen::MatrixXd::Identity(6, 6);
  D.diagonal() << 1, 2, 3, 4, 5, 6;
  D(2, 5) = D(5, 2) = 0.5;
  EXPECT_EQ(restrictCloseness(D, fit), (Eigen::MatrixXd(2, 2) << 3, 0.5, 0.5, 6).finished());
  EXPECT_THROW(fitStructured(data.X, data.U, Eigen::MatrixXd::Zero(2, 3)), DataError);
  EXPECT_THROW(fitStructured(data.X, data.U, Eigen::MatrixXd::Constant(3, 3, NAN)), DataError);
}
