#include <gtest/gtest.h>

#include <cmath>

#include "explore_opt/exploration_design.hpp"
#include "explore_opt/predicted_response.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using explore_opt::testing::auditedBound;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::simulatedLambdaMin;
using explore_opt::testing::simulatedRegressor;
using explore_opt::testing::thesisProblem;
using quad_support::DataError;

namespace {

/// Stable, two states, two inputs; lines spread over the band.
ExplorationProblem twoInputs(std::uint64_t seed, Phase phase = Phase::kCos) {
  ExplorationProblem problem;
  problem.A =
      (MatrixXd(2, 2) << 0.8, 0.2, -0.1, 0.7).finished() + 0.1 * randomMatrix(seed, 0, 2, 2);
  problem.B = randomMatrix(seed, 1, 2, 2);
  problem.lines = {100, {2, 7, 13, 24}, {}};
  problem.phase = phase;
  problem.gamma_w = 1.0;
  problem.D_des = MatrixXd::Constant(1, 1, 50.0);
  return problem;
}

/// Everything an answer claims, checked against plain simulation.
void audit(const ExplorationProblem& problem, const DesignResult& result) {
  ASSERT_TRUE(result.feasible()) << result.message;
  EXPECT_NEAR(result.amplitudes.norm(), result.gamma_e, 1e-14 * result.gamma_e);
  // Eigenvalues of N round to 1e-16 of the largest, which is up to 1e6 times the smallest.
  EXPECT_GE(result.lambda_min, 1.0 - 1e-12);
  EXPECT_NEAR(simulatedLambdaMin(problem, result.amplitudes), result.lambda_min, 1e-8);
  EXPECT_GE(explore_opt::testing::smallestEigenvalue(result.certificate),
            -1e-12 * result.certificate.trace());
  EXPECT_NEAR(auditedBound(problem, result.certificate), result.lower_bound,
              1e-8 * result.lower_bound);
  EXPECT_LE(result.lower_bound, result.gamma_e);
  EXPECT_NEAR(result.gap, 1.0 - result.lower_bound / result.gamma_e, 1e-15);
  EXPECT_GT(result.amplitudes.maxCoeff(), 0.0);
  EXPECT_EQ(result.amplitudes.maxCoeff(), result.amplitudes.cwiseAbs().maxCoeff());
}

double inputBlockBound(const ExplorationProblem& problem) {  // γ_e² >= 2 γ_w tr(D_uu)/T on the grid
  return std::sqrt(2.0 * problem.gamma_w * problem.D_des(0, 0) * problem.numInputs() /
                   problem.lines.num_samples);
}

MatrixXd column(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.begin(),
                                           static_cast<Eigen::Index>(values.size()));
}

}  // namespace

TEST(PredictedResponse, EqualsTheSimulation) {
  for (const Phase phase : {Phase::kSin, Phase::kCos, Phase::kBoth}) {
    for (const ExplorationProblem& problem : {thesisProblem(phase), twoInputs(1, phase)}) {
      const PredictedResponse response = predictResponse(problem);
      const int rows = numCarriers(problem.lines, phase), nu = problem.numInputs();
      const MatrixXd amplitudes = randomMatrix(2, 0, rows, nu);
      Eigen::VectorXd a(problem.numAmplitudes());
      for (int i = 0; i < a.size(); ++i) a(i) = amplitudes(i / nu, i % nu);
      const MatrixXd phi = simulatedRegressor(problem, amplitudes);
      const MatrixXd N = explore_opt::testing::normalised(problem, phi * phi.transpose());
      EXPECT_LT((response.information(a) - N).norm(), 1e-11 * N.norm());  // sums of 370 products
      EXPECT_LE(response.factors.front().rows(), a.size() * problem.numRegressors());
    }
  }
}

TEST(PredictedResponse, FeedbackIsPartOfTheInput) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.K = (MatrixXd(1, 2) << -1.5, -2.0).finished();
  const MatrixXd amplitudes = column({0.5, 0.9, 1.5, 2.7});
  const MatrixXd phi = simulatedRegressor(problem, amplitudes);
  const MatrixXd N = explore_opt::testing::normalised(problem, phi * phi.transpose());
  EXPECT_LT((predictResponse(problem).information(amplitudes) - N).norm(), 1e-11 * N.norm());
  EXPECT_EQ(unitResponse(problem, 0)(2, 0), 1.0);  // at rest the input is the carrier alone
}

TEST(PredictedResponse, RefusesResponsesThatOverflow) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.A *= 10.0;
  EXPECT_THROW(predictResponse(problem), DataError);
}

// Golden values: certified optima computed with independent programs; printed to 1e-5.
TEST(Design, ThesisOptimaAreCertified) {
  for (const auto& [phase, cost] : {std::pair{Phase::kSin, 3.29389}, {Phase::kCos, 3.31937}}) {
    const ExplorationProblem problem = thesisProblem(phase);
    const DesignResult result = designExploration(problem);
    SCOPED_TRACE(toString(phase));
    EXPECT_EQ(result.status, DesignStatus::kSolved);
    EXPECT_NEAR(result.gamma_e, cost, 1e-5);
    EXPECT_LE(result.gap, 1e-8);
    audit(problem, result);
  }
  EXPECT_NEAR(designExploration(thesisProblem(Phase::kSin)).gamma_e, 3.29,
              5e-3);  // thesis section 2.4.2
}

TEST(Design, CosineAmplitudes) {
  // 8 % of all directions are within 1 % of this optimum: amplitudes are known to three decimals.
  const DesignResult result = designExploration(thesisProblem(Phase::kCos));
  EXPECT_LT((result.amplitudes - column({0.488, 0.917, 1.538, 2.752})).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Design, CostsOfDirections) {
  const ExplorationProblem sine = thesisProblem(Phase::kSin), cosine = thesisProblem(Phase::kCos);
  const MatrixXd ones = MatrixXd::Ones(4, 1), thesis = column({0.04, 0.94, 1.76, -2.62});
  EXPECT_NEAR(scaledCost(sine, ones), 3.4022, 5e-5);
  EXPECT_NEAR(scaledCost(cosine, ones), 3.3602, 5e-5);
  EXPECT_NEAR(scaledCost(sine, thesis), 3.3024, 5e-5);  // what the thesis computed was the sine
  EXPECT_NEAR(scaledCost(cosine, thesis), 4.3622, 5e-5);
  EXPECT_NEAR(scaledCost(sine, -7.0 * thesis), scaledCost(sine, thesis), 1e-12);
  EXPECT_NEAR(inputBlockBound(sine), 3.28798, 5e-6);
}

TEST(Design, NoDirectionBeatsTheBound) {
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  const double bound = designExploration(problem).lower_bound;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_GE(scaledCost(problem, randomMatrix(seed, 0, 4, 1)), bound) << seed;
  }
  EXPECT_GE(bound, inputBlockBound(problem));
}

TEST(Design, AnyCertificateBounds) {
  const ExplorationProblem problem = thesisProblem(Phase::kSin);
  const double optimum = designExploration(problem).gamma_e;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const MatrixXd m = randomMatrix(seed, 0, 3, 3), Z = m * m.transpose();
    EXPECT_LE(lowerBound(problem, Z), optimum);
    EXPECT_NEAR(lowerBound(problem, Z), auditedBound(problem, Z), 1e-8 * optimum);
  }
  MatrixXd input = MatrixXd::Zero(3, 3);  // supported on the input block: the closed form
  input(2, 2) = 1.0;
  EXPECT_NEAR(lowerBound(problem, input), inputBlockBound(problem), 1e-10);
}

TEST(Design, ScalesWithGammaAndCloseness) {  // N is homogeneous: γ_e ~ sqrt(γ_w λ)
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  const double base = designExploration(problem).gamma_e;
  problem.gamma_w *= 4.0;
  EXPECT_NEAR(designExploration(problem).gamma_e, 2.0 * base, 1e-8 * base);
  problem.D_des *= 1e4;
  EXPECT_NEAR(designExploration(problem).gamma_e, 200.0 * base, 1e-6 * base);
}

TEST(Design, ClosenessInThreeShapes) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  const DesignResult scalar = designExploration(problem);
  problem.D_des = 100.0 * MatrixXd::Identity(3, 3);
  const DesignResult kronecker = designExploration(problem);
  problem.D_des = 100.0 * MatrixXd::Identity(6, 6);
  const DesignResult full = designExploration(problem);
  EXPECT_NEAR(kronecker.gamma_e, scalar.gamma_e, 1e-9 * scalar.gamma_e);
  EXPECT_NEAR(full.gamma_e, scalar.gamma_e,
              1e-7 * scalar.gamma_e);  // every eigenvalue twice: a degenerate optimum
  EXPECT_LE(full.gap, 1e-6);
  audit(problem, full);
}

TEST(Design, GeneralCloseness) {
  ExplorationProblem problem = thesisProblem(Phase::kSin);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const MatrixXd m = randomMatrix(seed, 0, 6, 6);
    problem.D_des = 20.0 * (m * m.transpose() + MatrixXd::Identity(6, 6));
    const DesignResult result = designExploration(problem);
    audit(problem, result);
    EXPECT_LE(result.gap, 1e-4);
  }
}

TEST(Design, RandomSingleInputSystemsAreSolvedToGlobalOptimality) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    ExplorationProblem problem = twoInputs(seed);
    problem.B = problem.B.leftCols(1).eval();
    const DesignResult result = designExploration(problem);
    audit(problem, result);
    EXPECT_LE(result.gap, 1e-4);  // such systems have shown gaps up to 1.1e-5
  }
}

TEST(Design, TwoInputs) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const DesignResult one = designExploration(twoInputs(seed)),
                       both = designExploration(twoInputs(seed, Phase::kBoth));
    audit(twoInputs(seed), one);
    audit(twoInputs(seed, Phase::kBoth), both);
    EXPECT_LE(one.gap, 0.08);
    EXPECT_LE(both.gap, 1e-3);                            // both phases close the gap
    EXPECT_LE(both.gamma_e, one.gamma_e * (1.0 + 1e-9));  // more carriers cannot cost more
  }
}

TEST(Design, SameInputSameBits) {
  const DesignResult a = designExploration(thesisProblem(Phase::kCos)),
                     b = designExploration(thesisProblem(Phase::kCos));
  EXPECT_EQ(a.amplitudes, b.amplitudes);
  EXPECT_EQ(a.certificate, b.certificate);
}

TEST(Design, LongExperiments) {
  const ExplorationProblem problem = thesisProblem(Phase::kSin, 3700);
  const DesignResult result = designExploration(problem);
  EXPECT_LE(result.gap, 1e-7);
  audit(problem, result);
}

TEST(Design, FrequenciesOffTheGrid) {
  ExplorationProblem problem = thesisProblem(Phase::kSin);
  problem.lines.harmonics.clear();
  for (const int i : {3, 6, 8, 10})
    problem.lines.frequencies.push_back(i / 8.0 * crossoverFrequency(0.73) * 0.1);
  const DesignResult result = designExploration(problem);
  audit(problem, result);
  EXPECT_LE(result.gap, 1e-5);
  EXPECT_NEAR(result.gamma_e, 3.29, 0.05);  // 36.69 s in place of 37 s: nearly the same lines
}

TEST(Design, SaysWhenNothingExcites) {
  ExplorationProblem problem = twoInputs(1);
  problem.lines.harmonics = {
      5};  // one line, one phase: both inputs are in step for every amplitude
  for (const DesignMethod method : {DesignMethod::kGlobal, DesignMethod::kMm}) {
    DesignOptions options;
    options.method = method;
    const DesignResult result = designExploration(problem, options);
    EXPECT_EQ(result.status, DesignStatus::kNotExciting);
    EXPECT_FALSE(result.feasible());
    EXPECT_TRUE(std::isnan(result.gamma_e));
  }
  problem = thesisProblem(Phase::kCos);
  problem.B.setZero();  // not controllable
  EXPECT_EQ(designExploration(problem).status, DesignStatus::kNotExciting);
}

TEST(Majorisation, ReachesTheCosineOptimum) {
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  DesignOptions options;
  options.method = DesignMethod::kMm;
  const DesignResult result = designExploration(problem, options);
  EXPECT_EQ(result.status, DesignStatus::kSolved);
  EXPECT_NEAR(result.gamma_e, 3.31937, 1e-5);
  EXPECT_LT((result.amplitudes - column({0.488, 0.917, 1.538, 2.752})).cwiseAbs().maxCoeff(), 1e-3);
  audit(problem, result);
}

TEST(Majorisation, DescendsAndRecordsEveryStep) {
  for (const bool extrapolate : {false, true}) {
    SCOPED_TRACE(extrapolate);
    DesignOptions options;
    options.method = DesignMethod::kMm;
    options.extrapolate = extrapolate;
    options.max_iterations = 15;
    const ExplorationProblem problem = thesisProblem(Phase::kCos);
    const DesignResult result = designExploration(problem, options);
    EXPECT_EQ(result.status, DesignStatus::kIterationLimit);
    ASSERT_EQ(result.iterations.size(), 16u);
    EXPECT_NEAR(result.iterations[0].gamma_e, 3.3602, 5e-5);  // starts with equal amplitudes
    for (std::size_t i = 1; i < result.iterations.size(); ++i) {
      const DesignIteration &before = result.iterations[i - 1], &now = result.iterations[i];
      EXPECT_LT(now.gamma_e, before.gamma_e);
      EXPECT_NEAR(now.step, (now.amplitudes - before.amplitudes).norm(), 1e-12);
      EXPECT_NEAR(simulatedLambdaMin(problem, now.amplitudes), 1.0,
                  1e-8);  // each is feasible, on the boundary
      EXPECT_GT(now.inner_gap, 0.0);
      if (extrapolate) continue;
      // Strong convexity: ½‖a_j‖² - ½‖a_j+1‖² >= ½‖a_j - a_j+1‖², up to the inner gap.
      EXPECT_GE(
          0.5 * (before.gamma_e * before.gamma_e - now.gamma_e * now.gamma_e) + 2.0 * now.inner_gap,
          0.5 * now.step * now.step);
    }
    audit(problem, result);
  }
}

TEST(Majorisation, InnerGapIsWhatWasAskedFor) {
  DesignOptions options;
  options.method = DesignMethod::kMm;
  for (const double gap : {1e-5, 1e-7}) {
    options.inner_gap = gap;
    options.cost_tolerance = 1e-6;
    const DesignResult result = designExploration(thesisProblem(Phase::kCos), options);
    const double relative = result.inner_gap / (0.5 * result.gamma_e * result.gamma_e);
    EXPECT_NEAR(relative, gap,
                0.1 * gap);  // n μ exactly at the centre; the solver stops a little off it
  }
}

TEST(Majorisation, StartsFromAnyExcitingCandidate) {
  DesignOptions options;
  options.method = DesignMethod::kMm;
  options.cost_tolerance = 1e-6;
  options.step_tolerance = 1e-2;
  for (const double size : {1e-3, 1e3}) {
    options.initial_amplitudes = size * column({1, -1, 1, 1});
    const DesignResult result = designExploration(thesisProblem(Phase::kCos), options);
    EXPECT_NEAR(result.gamma_e, 3.31937, 0.02);
    EXPECT_NEAR(result.iterations.front().gamma_e,
                scaledCost(thesisProblem(Phase::kCos), column({1, -1, 1, 1})), 1e-9);
  }
  options.initial_amplitudes = Eigen::VectorXd::Zero(4);
  EXPECT_EQ(designExploration(thesisProblem(Phase::kCos), options).status,
            DesignStatus::kNotExciting);
  options.initial_amplitudes = Eigen::VectorXd::Ones(3);
  EXPECT_THROW(designExploration(thesisProblem(Phase::kCos), options), DataError);
}

TEST(Majorisation, ThresholdsOfTheThesisStopEarly) {
  DesignOptions options;
  options.method = DesignMethod::kMm;
  options.extrapolate = false;
  options.cost_tolerance = 1e-3;
  options.step_tolerance = 1e-2;
  const DesignResult result = designExploration(thesisProblem(Phase::kSin), options);
  EXPECT_EQ(result.status, DesignStatus::kSolved);
  EXPECT_LT(result.iterations.size(), 100u);
  EXPECT_NEAR(result.gamma_e, 3.30,
              0.01);  // a few tenths of a per cent above the optimum, as the thesis's 3.302
}

TEST(Validation, NamesWhatIsWrong) {
  const auto message = [](void (*spoil)(ExplorationProblem&)) -> std::string {
    ExplorationProblem problem = thesisProblem(Phase::kSin);
    spoil(problem);
    try {
      validate(problem);
    } catch (const DataError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message([](ExplorationProblem&) {}), "");
  EXPECT_EQ(message([](ExplorationProblem& p) { p.gamma_w = 0.0; }),
            "gamma_w = 0; must be a finite number above 0");
  EXPECT_NE(message([](ExplorationProblem& p) { p.gamma_w = NAN; }), "");
  EXPECT_EQ(message([](ExplorationProblem& p) { p.A = MatrixXd::Zero(2, 3); }),
            "A is 2 x 3; must be 2 x 2");
  EXPECT_EQ(message([](ExplorationProblem& p) { p.B = MatrixXd::Zero(3, 1); }),
            "B is 3 x 1; must be 2 x 1");
  EXPECT_NE(message([](ExplorationProblem& p) { p.B = MatrixXd::Zero(2, 0); }), "");
  EXPECT_NE(message([](ExplorationProblem& p) { p.A(0, 0) = NAN; }), "");
  EXPECT_NE(message([](ExplorationProblem& p) { p.D_des = MatrixXd::Identity(4, 4); }), "");
  EXPECT_NE(message([](ExplorationProblem& p) { p.D_des = MatrixXd::Constant(1, 1, -1.0); }), "");
  EXPECT_NE(message([](ExplorationProblem& p) { p.D_des = MatrixXd::Zero(3, 3); }), "");
  EXPECT_NE(
      message([](ExplorationProblem& p) { p.D_des = Eigen::Vector3d(1, 1, -1).asDiagonal(); }), "");
  EXPECT_NE(message([](ExplorationProblem& p) {
              p.D_des = MatrixXd::Identity(3, 3);
              p.D_des(0, 1) = 0.1;
            }),
            "");
  EXPECT_EQ(message([](ExplorationProblem& p) { p.x0 = Eigen::VectorXd::Ones(3); }),
            "x0 is 3 x 1; must be 2 x 1");
  EXPECT_EQ(message([](ExplorationProblem& p) { p.x0 = Eigen::Vector2d(0, 0); }), "");
  EXPECT_EQ(message([](ExplorationProblem& p) { p.K = MatrixXd::Zero(2, 2); }),
            "K is 2 x 2; must be 1 x 2");
  EXPECT_THROW(methodFromString("best"), DataError);
  DesignOptions options;
  options.max_iterations = 0;
  EXPECT_THROW(designExploration(thesisProblem(Phase::kSin), options), DataError);
}
