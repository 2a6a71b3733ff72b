/// Costs of other signals: against plain simulation, against random search, and where they matter.
#include <gtest/gtest.h>

#include <cmath>

#include "explore_opt/audit.hpp"
#include "explore_opt/baselines.hpp"
#include "explore_opt/classical_designs.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/signal_response.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::thesisProblem;

namespace {

/// A stable random system of two inputs with feedback and a full D_des.
ExplorationProblem randomProblem(std::uint64_t seed, bool full) {
  ExplorationProblem problem;
  problem.A = 0.2 * randomMatrix(seed, 0, 3, 3);
  problem.B = randomMatrix(seed, 1, 3, 2);
  problem.K = 0.05 * randomMatrix(seed, 2, 2, 3);
  problem.lines = {200, {3, 11, 20, 47}, {}};
  problem.phase = Phase::kBoth;
  problem.gamma_w = 2.5;
  const int n = full ? 15 : 5;
  const Eigen::MatrixXd root = randomMatrix(seed, 3, n, n);
  problem.D_des = root * root.transpose() + Eigen::MatrixXd::Identity(n, n);
  return problem;
}

const BaselineCost& find(const std::vector<BaselineCost>& rows, const std::string& name) {
  for (const BaselineCost& row : rows) {
    if (row.name == name) return row;
  }
  throw std::invalid_argument(name);
}

}  // namespace

TEST(SignalResponse, ScaleMeetsTheConditionExactly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const ExplorationProblem problem = randomProblem(seed, seed % 2 == 1);
    const Eigen::MatrixXd a = randomMatrix(seed, 4, 8, 2);
    const double s = requiredScale(problem, multisine(problem.lines, problem.phase, a));
    // λ_min by another simulation and another factorisation; D has a condition of about 1e3.
    EXPECT_NEAR(explore_opt::testing::simulatedLambdaMin(problem, s * a), 1.0, 1e-10);
    EXPECT_NEAR(s * a.norm(), scaledCost(problem, a), 1e-10 * s * a.norm());
  }
}

TEST(SignalResponse, ScaleHoldsForStartKnownEntriesAndSingularCloseness) {
  for (int kind = 0; kind < 4; ++kind) {
    SCOPED_TRACE(kind);
    ExplorationProblem problem = thesisProblem(Phase::kCos);
    if (kind == 0) problem.x0 = Eigen::Vector2d(3.0, -1.0);
    if (kind == 1) problem.known = (Eigen::MatrixXd(2, 3) << 1, NAN, NAN, 0, 1, NAN).finished();
    if (kind == 2) problem.D_des = Eigen::Vector3d(100, 0, 100).asDiagonal();
    if (kind == 3) problem.K = (Eigen::MatrixXd(1, 2) << -0.1, -0.4).finished();
    DesignClaims claims;
    claims.amplitudes = randomMatrix(3, 0, 4, 1);
    claims.amplitudes *=
        requiredScale(problem, multisine(problem.lines, problem.phase, claims.amplitudes));
    EXPECT_NEAR(audit(problem, claims).lambda_min, 1.0, 1e-9);  // bisection ends at 1e-12
  }
}

TEST(SignalResponse, EquivalentAmplitudeIsTheNormOnTheGrid) {
  const ExplorationProblem problem = thesisProblem(Phase::kSin);
  const Eigen::MatrixXd a = randomMatrix(1, 0, 4, 1);
  EXPECT_NEAR(equivalentAmplitude(multisine(problem.lines, problem.phase, a)), a.norm(),
              1e-13 * a.norm());
}

TEST(SignalResponse, NoScaleHelpsASignalThatDoesNotExcite) {
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  EXPECT_EQ(requiredScale(problem, Eigen::MatrixXd::Zero(1, 370)),
            std::numeric_limits<double>::infinity());
  EXPECT_THROW(requiredScale(problem, Eigen::MatrixXd::Zero(1, 371)), quad_support::DataError);
  EXPECT_THROW(requiredScale(problem, Eigen::MatrixXd::Zero(2, 370)), quad_support::DataError);
}

TEST(SignalResponse, SaysThatTheStatesOverflow) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.A *= 10.0;
  try {
    simulateNominal(problem, Eigen::MatrixXd::Constant(1, 370, 1.0));
    FAIL();
  } catch (const quad_support::DataError& e) {
    EXPECT_NE(std::string(e.what()).find("overflow at sample"), std::string::npos) << e.what();
  }
}

TEST(ClassicalDesigns, NoRandomDirectionIsBetter) {
  for (const bool thesis : {true, false}) {
    const ExplorationProblem problem =
        thesis ? thesisProblem(Phase::kCos) : randomProblem(3, false);
    const auto information = [&](const Eigen::MatrixXd& a) {
      const Eigen::MatrixXd phi = explore_opt::testing::simulatedRegressor(problem, a);
      const Eigen::MatrixXd S = phi * phi.transpose() / a.squaredNorm();
      return Eigen::VectorXd(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(S).eigenvalues());
    };
    const auto D = [&](const auto& a) { return information(a).array().log().sum(); };
    const auto A = [&](const auto& a) { return -information(a).cwiseInverse().sum(); };
    const auto E = [&](const auto& a) { return information(a)(0); };
    const Eigen::MatrixXd d = classicalDesign(problem, ClassicalCriterion::kD),
                          a = classicalDesign(problem, ClassicalCriterion::kA),
                          e = classicalDesign(problem, ClassicalCriterion::kE);
    for (const auto& design : {d, a, e}) EXPECT_NEAR(design.norm(), 1.0, 1e-12);
    EXPECT_GT(D(d), std::max(D(a), D(e)));
    EXPECT_GT(A(a), std::max(A(d), A(e)));
    EXPECT_GT(E(e), std::max(E(d), E(a)));
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Eigen::MatrixXd away =
          randomMatrix(i, 5, static_cast<int>(d.rows()), static_cast<int>(d.cols()));
      const double size = i % 2 == 0 ? 1.0 : 1e-3;  // anywhere, and near by
      EXPECT_GE(D(d), D(Eigen::MatrixXd(d + size * away)) - 1e-9);
      EXPECT_GE(A(a), A(Eigen::MatrixXd(a + size * away)) * (1 - 1e-9 * (A(a) < 0 ? -1 : 1)));
    }
  }
}

TEST(ClassicalDesigns, AreEmptyWhereNothingExcites) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.B.setZero();
  for (const ClassicalCriterion criterion : allCriteria())
    EXPECT_EQ(classicalDesign(problem, criterion).size(), 0) << toString(criterion);
}

TEST(Baselines, HardlyMatterOnTheThesisProblem) {
  const ExplorationProblem problem = thesisProblem(Phase::kSin);
  const DesignResult design = designExploration(problem);
  BaselineOptions options;
  options.seeds = 5;
  const auto rows = compareBaselines(problem, design.amplitudes, options);
  EXPECT_NEAR(find(rows, "targeted").cost, design.gamma_e, 1e-9);
  EXPECT_NEAR(find(rows, "E-optimal").cost, design.gamma_e, 1e-4);  // D_des is a multiple of I
  // The bound of the input block, 3.28798, holds for every signal, and white noise comes near.
  for (const BaselineCost& row : rows) EXPECT_GT(row.least, 3.28798) << row.name;
  EXPECT_LT(find(rows, "white").cost, 1.05 * design.gamma_e);
  // A chirp is not bound to the four lines.
  EXPECT_LT(find(rows, "chirp").cost, design.gamma_e);
}

TEST(Baselines, TargetingHalvesTheAmplitudeWhereOneModeMatters) {
  const std::string path = EXPLORE_OPT_EXAMPLES "/flexible_structure.json";
  const ExplorationProblem problem = problemFromJson(quad_support::readFile(path), path);
  const DesignResult design = designExploration(problem);
  ASSERT_TRUE(design.feasible());
  EXPECT_LT(design.gap, 1e-4);
  BaselineOptions options;
  options.seeds = 3;
  const auto rows = compareBaselines(problem, design.amplitudes, options);
  EXPECT_EQ(rows.size(), 11u);
  for (const BaselineCost& row : rows) {
    if (row.name == "targeted") continue;
    EXPECT_GE(row.cost, 2.0 * rows.front().cost) << row.name;
  }
}

TEST(Baselines, RefuseOptionsOutOfRange) {
  const ExplorationProblem problem = thesisProblem(Phase::kSin);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Ones(4, 1);
  BaselineOptions options;
  options.seeds = 0;
  EXPECT_THROW(compareBaselines(problem, a, options), quad_support::DataError);
  options = {};
  options.band_low = 0.3;
  options.band_high = 0.2;
  EXPECT_THROW(compareBaselines(problem, a, options), quad_support::DataError);
}
