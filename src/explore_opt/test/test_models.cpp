#include <gtest/gtest.h>

#include <cmath>

#include "explore_opt/altitude_model.hpp"
#include "explore_opt/disturbance_energy.hpp"
#include "explore_opt/initial_estimate.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using explore_opt::testing::randomMatrix;
using quad_support::DataError;

namespace {

const AltitudeParameters kTruth{0.1, 0.73};
const AltitudeParameters kThesisEstimate{0.1635, 0.6247};

Eigen::MatrixXd joined(const LinearSystem& s) {
  Eigen::MatrixXd m(s.A.rows(), s.A.cols() + s.B.cols());
  m << s.A, s.B;
  return m;
}

}  // namespace

TEST(AltitudeModel, IsTheExactSolutionOfTheContinuousModel) {
  // Eq. (2.1), d/dt [z; ż; U; 1] = G [z; ż; U; 1]; G³ = 0, so exp(G dT) is a polynomial of
  // degree 2.
  const double mass = 0.73, dT = 0.1, gravity = 9.8;
  Eigen::Matrix4d G = Eigen::Matrix4d::Zero();
  G(0, 1) = 1.0;
  G(1, 2) = 1.0 / mass;
  G(1, 3) = -gravity;
  const Eigen::Matrix4d exact = Eigen::Matrix4d::Identity() + G * dT + G * G * (0.5 * dT * dT);
  const LinearSystem closed = altitudeModel(mass, dT, gravity);
  EXPECT_LT((exact.topLeftCorner(2, 2) - closed.A).norm(), 1e-15);
  EXPECT_LT((exact.block(0, 2, 2, 1) - closed.B).norm(), 1e-15);
  EXPECT_LT((exact.topRightCorner(2, 1) - closed.W).norm(), 1e-15);
}

TEST(AltitudeModel, PrintedMatricesOfTheThesis) {
  const LinearSystem truth = altitudeModel(0.73, 0.1, 9.8),
                     nominal = altitudeModel(0.6247, 0.1635, 9.8);
  // Printed to four decimals: half a unit of the last place.
  EXPECT_NEAR(truth.B(0), 0.0068, 5e-5);
  EXPECT_NEAR(truth.B(1), 0.1370, 5e-5);
  EXPECT_NEAR(truth.W(0), -0.0490, 5e-5);
  EXPECT_NEAR(truth.W(1), -0.98, 5e-5);
  EXPECT_NEAR(nominal.B(0), 0.0214, 5e-5);
  EXPECT_NEAR(nominal.B(1), 0.2617, 5e-5);
  EXPECT_THROW(altitudeModel(0.0, 0.1, 9.8), DataError);
  EXPECT_THROW(altitudeModel(0.73, -0.1, 9.8), DataError);
}

TEST(FrequencyGrid, ThesisChoice) {
  const FrequencyGrid grid = crossoverGrid(0.73, 0.1);
  EXPECT_NEAR(grid.crossover, 0.218, 5e-4);   // printed to three decimals
  EXPECT_NEAR(grid.exact_time, 36.69, 5e-3);  // 8/f_c = 16 π m
  EXPECT_EQ(grid.exploration_time, 37.0);
  EXPECT_EQ(grid.num_samples, 370);
  EXPECT_EQ(grid.harmonics, (std::vector<int>{3, 6, 8, 10}));
  EXPECT_DOUBLE_EQ(grid.frequencies[2], 8.0 / 37.0);
}

TEST(FrequencyGrid, FromTheEstimateItIsAnother) {
  const FrequencyGrid grid = crossoverGrid(0.6247, 0.1635);
  EXPECT_EQ(grid.exploration_time, 31.0);             // 16 π 0.6247 = 31.40
  EXPECT_EQ(grid.num_samples, 190);                   // 31/0.1635 = 189.6
  EXPECT_THROW(crossoverGrid(0.73, 2.0), DataError);  // 18 samples do not hold ten lines
}

TEST(InitialEstimate, ErrorNormsOfTable21) {
  struct Row {
    double closeness, dT, m, norm;
  };
  // All rows of the table; dT and m are printed to 5e-5, which moves ‖e‖ by up to |∂e/∂dT| 5e-5 +
  // |∂e/∂m| 5e-5: the slopes are about 1/m and dT/m² (below 4 and 2 here), so 3e-4 covers them and
  // the printed 5e-5.
  for (const Row& row :
       {Row{1, -0.6432, -0.8596, 0.9936}, Row{10, 0.1411, 0.3141, 0.3158},
        Row{50, 0.1635, 0.6247, 0.1407}, Row{100, 0.0512, 0.2287, 0.0997},
        Row{500, 0.1430, 0.9694, 0.0444}, Row{1000, 0.0829, 0.5071, 0.0315},
        Row{10000, 0.0906, 0.6779, 0.0100}, Row{1000000, 0.0993, 0.7281, 0.0010}}) {
    SCOPED_TRACE(row.closeness);
    Eigen::MatrixXd estimate(2, 3);  // by hand: the first row is not a physical model
    estimate << 1, row.dT, row.dT * row.dT / (2 * row.m), 0, 1, row.dT / row.m;
    EXPECT_NEAR(errorNorm(joined(altitudeModel(0.73, 0.1, 0.0)), estimate), row.norm, 3e-4);
  }
}

TEST(InitialEstimate, ClosenessOfTheThesisEstimate) {
  EXPECT_NEAR(closenessOfEstimate(kTruth, kThesisEstimate), 50.4955,
              5e-5);  // by hand from the printed dT, m
  // The printed 50.4868 lies within what draws rounding to 0.1635 and 0.6247 can give.
  const double low = closenessOfEstimate(kTruth, {0.16355, 0.62465}),
               high = closenessOfEstimate(kTruth, {0.16345, 0.62475});
  EXPECT_LT(low, 50.4868);
  EXPECT_GT(high, 50.4868);
  EXPECT_LT(high - low, 0.2);
}

TEST(InitialEstimate, DrawsHaveTheClosenessAskedFor) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    for (const double closeness : {10.0, 50.0, 1e4}) {
      const InitialEstimate draw = drawInitialEstimate(kTruth, closeness, seed);
      EXPECT_GT(draw.parameters.sampling_period, 0.0);
      EXPECT_GT(draw.parameters.mass, 0.0);
      // Bisection to neighbouring doubles; the error's square is known to about 1e-14/‖e‖ relative.
      EXPECT_NEAR(closenessOfEstimate(kTruth, draw.parameters), closeness, 1e-9 * closeness);
    }
  }
}

TEST(InitialEstimate, DrawTakesTheFirstCrossing) {
  const InitialEstimate draw = drawInitialEstimate(kTruth, 50.0, 3);
  const double n1 =
      (draw.parameters.sampling_period - kTruth.sampling_period) / draw.standard_deviation;
  const double n2 = (draw.parameters.mass - kTruth.mass) / draw.standard_deviation;
  for (double part = 0.001; part < 1.0;
       part += 0.001) {  // inside, the estimate is closer than asked
    const double sigma = part * draw.standard_deviation;
    EXPECT_GT(closenessOfEstimate(kTruth,
                                  {kTruth.sampling_period + sigma * n1, kTruth.mass + sigma * n2}),
              50.0);
  }
}

TEST(InitialEstimate, DrawIsAddressedBySeedAndRun) {
  const auto dT = [](std::uint64_t seed, std::uint64_t run) {
    return drawInitialEstimate(kTruth, 50.0, seed, run).parameters.sampling_period;
  };
  EXPECT_EQ(dT(1, 0), dT(1, 0));
  EXPECT_NE(dT(1, 0), dT(2, 0));
  EXPECT_NE(dT(1, 0), dT(1, 1));
  EXPECT_THROW(drawInitialEstimate(kTruth, 0.0, 1), DataError);
}

TEST(DisturbanceEnergy, BeforeTheExperiment) {
  const LinearSystem truth = altitudeModel(0.73, 0.1, 9.8);
  // By hand: 370 g² dT² (1 + dT²/4) = 370 · 0.9604 · 1.0025 = 356.23637; the thesis prints 356.23.
  EXPECT_NEAR(constantDisturbanceEnergy(truth.W, 370), 356.23637, 1e-9);
  EXPECT_NEAR(constantDisturbanceEnergy(truth.W, 370), 356.23, 0.01);
  const Eigen::VectorXd left =
      compensatedDisturbance(truth, Eigen::VectorXd::Constant(1, 0.6247 * 9.8));
  const double share = 0.6247 / 0.73 - 1.0;
  EXPECT_NEAR(constantDisturbanceEnergy(left, 370), 356.23637 * share * share, 1e-9);
  EXPECT_NEAR(constantDisturbanceEnergy(left, 370), 7.41, 5e-3);  // Eq. (2.3)
  const Eigen::VectorXd none =
      compensatedDisturbance(truth, Eigen::VectorXd::Constant(1, 0.73 * 9.8));
  EXPECT_LT(constantDisturbanceEnergy(none, 370), 1e-25);
}

TEST(DisturbanceEnergy, OneStepEnergyIsTheEnergyOfWhatWasAdded) {
  const LinearSystem truth = altitudeModel(0.73, 0.1, 9.8);
  const Eigen::MatrixXd U = randomMatrix(1, 0, 1, 370), noise = 0.05 * randomMatrix(1, 1, 2, 370);
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(2, 371);
  for (int k = 0; k < 370; ++k)
    X.col(k + 1) = truth.A * X.col(k) + truth.B * U.col(k) + truth.W + noise.col(k);
  EXPECT_NEAR(oneStepEnergy(truth, X, U), noise.squaredNorm(),
              1e-9);  // |x| reaches 7e3: rounding 1e-12 a sample
  const LinearSystem without{truth.A, truth.B, {}};
  EXPECT_NEAR(oneStepEnergy(without, X, U), (noise.colwise() + truth.W).squaredNorm(), 1e-9);
}

TEST(DisturbanceEnergy, SimulationOfAnIntegratorIsAbsurdlyMuch) {
  const LinearSystem truth = altitudeModel(0.73, 0.1, 0.0),
                     nominal = altitudeModel(0.6247, 0.1635, 0.0);
  const Eigen::MatrixXd U = randomMatrix(2, 0, 1, 370);
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(2, 371);
  for (int k = 0; k < 370; ++k) X.col(k + 1) = truth.A * X.col(k) + truth.B * U.col(k);
  EXPECT_LT(simulationEnergy(truth, X, U), 1e-20);
  EXPECT_GT(simulationEnergy(nominal, X, U), 50.0 * oneStepEnergy(nominal, X, U));
  // First sample by hand: x̂_1 = B̂ u_0.
  const double first = (X.col(1) - nominal.B * U(0, 0)).squaredNorm();
  EXPECT_NEAR(simulationEnergy(nominal, X.leftCols(2), U.leftCols(1)), first, 1e-15);
}

TEST(DisturbanceEnergy, RefusesWrongShapes) {
  const LinearSystem truth = altitudeModel(0.73, 0.1, 9.8);
  EXPECT_THROW(oneStepEnergy(truth, Eigen::MatrixXd::Zero(2, 5), Eigen::MatrixXd::Zero(1, 5)),
               DataError);
  EXPECT_THROW(oneStepEnergy(truth, Eigen::MatrixXd::Zero(3, 6), Eigen::MatrixXd::Zero(1, 5)),
               DataError);
  EXPECT_THROW(constantDisturbanceEnergy(truth.W, 0), DataError);
}
