/// Costs of other signals: against plain simulation, against random search, and where they matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "explore_opt/audit.hpp"
#include "explore_opt/baselines.hpp"
#include "explore_opt/classical_designs.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/signal_response.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "raw_audit.hpp"
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

ExplorationProblem fromText(const std::string& text) { return problemFromJson(text, "text"); }

/// Two states of which the inputs move one; nothing is asked about the other.
const char* const kUnreachable =
    R"({"A": [[0.9, 0], [0, 0.5]], "B": [[1], [0]], "T": 100, "harmonics": [3, 11], "phase": "cos",
        "gamma_w": 1, "D_des": 10, "known": [[null, 0, null], [0, 0.5, 0]]})";
/// Two states that are always equal: only together with what is known can they be told apart.
const char* const kTwins =
    R"({"A": [[0.5, 0], [0, 0.5]], "B": [[1], [1]], "T": 100, "harmonics": [3, 11], "phase": "cos",
        "gamma_w": 1, "D_des": 10, "known": [[null, 0, null], [0, null, null]]})";
/// An integrator chain under feedback, the true input being paid for.
const char* const kFeedback =
    R"({"A": [[1, 0.5], [0, 1]], "B": [[0.1], [0.5]], "K": [[-0.3, -0.9]], "cost": "input", "T": 120,
        "harmonics": [3, 8, 15], "phase": "both", "gamma_w": 2, "D_des": 10})";
/// Lines slower than the experiment: amplitudes and energy are different things.
const char* const kOffGrid =
    R"({"A": [[0.9]], "B": [[1]], "T": 50, "frequencies": [0.0033, 0.011], "phase": "cos",
        "gamma_w": 1, "D_des": 3})";

/// One of each kind a design knows, all from rest.
std::vector<ExplorationProblem> kindsOfProblems() {
  std::vector<ExplorationProblem> problems;
  for (const char* const text : {kUnreachable, kTwins, kFeedback, kOffGrid})
    problems.push_back(fromText(text));
  ExplorationProblem problem = problems[2];  // feedback, cost on the input
  problem.phase = Phase::kCos;
  problems.push_back(problem);
  problem.lines.harmonics.clear();
  problem.lines.frequencies = {0.004, 0.03, 0.11};
  problem.experiments = 2;
  problems.push_back(problem);
  problem.known = (Eigen::MatrixXd(2, 3) << NAN, 0.5, NAN, 0, NAN, NAN).finished();
  problem.D_des = Eigen::Vector3d(10, 0, 4).asDiagonal();
  problems.push_back(problem);
  problem = problems[1];  // a full D_des of the unknown entries of twins
  problem.D_des = 10.0 * Eigen::MatrixXd::Identity(6, 6);
  problem.D_des(0, 4) = problem.D_des(4, 0) = 3.0;
  problems.push_back(problem);
  problem = fromText(R"({"A": [[0.6, 0.2], [-0.1, 0.7]], "B": [[1, 0.2], [0.1, 1]], "T": 60,
    "frequencies": [0.011, 0.15], "phase": "cos", "gamma_w": 1, "D_des": 5, "experiments": 2})");
  problems.push_back(problem);
  problem.phase = Phase::kBoth;
  problem.experiments = 1;
  problems.push_back(problem);
  return problems;
}

/// P⁻¹ on the unknown entries, Eᵀ(ΦΦᵀ ⊗ I)E.
Eigen::MatrixXd unknownInformation(const ExplorationProblem& problem, const Eigen::MatrixXd& phi) {
  const int nx = problem.numStates();
  const Eigen::MatrixXd all = explore_opt::testing::kroneckerIdentity(phi * phi.transpose(), nx);
  std::vector<int> entries;
  for (int i = 0; i < all.rows(); ++i) {
    if (problem.known.size() == 0 || std::isnan(problem.known(i % nx, i / nx)))
      entries.push_back(i);
  }
  return all(entries, entries);
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

TEST(SignalResponse, OnlyUnknownEntriesNeedBeDetermined) {
  for (const char* const text : {kUnreachable, kTwins}) {
    ExplorationProblem problem = fromText(text);
    const Eigen::MatrixXd a = randomMatrix(3, 0, 2, 1);
    const auto amplitudes = [&] {
      return Eigen::MatrixXd(requiredScale(problem, multisine(problem.lines, problem.phase, a)) *
                             a);
    };
    EXPECT_NEAR(explore_opt::testing::rawLambdaMin(problem, amplitudes()), 1.0, 1e-12);
    problem.x0 = Eigen::Vector2d(0.3, 0.3);  // bisection ends at 1e-12
    EXPECT_NEAR(explore_opt::testing::rawLambdaMin(problem, amplitudes()), 1.0, 1e-11);
    problem.x0.resize(0);
    problem.known.resize(0, 0);  // everything is asked for: no size is enough
    EXPECT_EQ(requiredScale(problem, multisine(problem.lines, problem.phase, a)),
              std::numeric_limits<double>::infinity());
  }
}

TEST(SignalResponse, InputAmplitudeIsThatOfTheTrueInput) {
  const ExplorationProblem problem = fromText(kFeedback);
  const Eigen::MatrixXd a = randomMatrix(1, 0, 6, 1);
  const Eigen::MatrixXd u =
      explore_opt::testing::simulatedRegressor(problem, a).bottomRows(problem.numInputs());
  EXPECT_NEAR(inputAmplitude(problem, multisine(problem.lines, problem.phase, a)),
              std::sqrt(2.0 / 120.0) * u.norm(), 1e-12 * u.norm());
}

TEST(SignalResponse, CheapestScaleLeavesTheLeastInput) {
  ExplorationProblem problem = fromText(kFeedback);
  problem.x0 = Eigen::Vector2d(80.0, 30.0);  // a way back that a signal can make cheaper
  bool larger = false;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::MatrixXd signal =
        multisine(problem.lines, problem.phase, randomMatrix(seed, 0, 6, 1));
    const double least = requiredScale(problem, signal), s = cheapestScale(problem, signal);
    ASSERT_GE(s, least);
    larger = larger || s > 1.01 * least;
    const double cost = inputAmplitude(problem, s * signal);
    for (double other = std::max(least, 1e-3); other < 1e3; other *= 1.1)
      EXPECT_LE(cost, inputAmplitude(problem, other * signal) * (1 + 1e-12)) << other;
    problem.cost = CostOn::kSignal;
    EXPECT_EQ(cheapestScale(problem, signal), least);
    problem.cost = CostOn::kInput;
  }
  EXPECT_TRUE(larger);
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

TEST(ClassicalDesigns, CountUnknownEntriesAndTheCostAskedFor) {
  std::vector<ExplorationProblem> problems = {fromText(kUnreachable), fromText(kTwins),
                                              fromText(kFeedback), randomProblem(3, false)};
  problems[3].cost = CostOn::kInput;
  problems[3].known = Eigen::MatrixXd::Constant(3, 5, NAN);  // one set of unknowns within another
  problems[3].known.leftCols(3) = problems[3].A;
  problems[3].known.row(0).setConstant(NAN);
  for (const ExplorationProblem& problem : problems) {
    SCOPED_TRACE(problem.known.rows() * 10 + problem.A.rows());
    const auto cost = [&](const Eigen::MatrixXd& a) {
      return problem.cost == CostOn::kSignal
                 ? a.norm()
                 : inputAmplitude(problem, multisine(problem.lines, problem.phase, a));
    };
    const auto information = [&](const Eigen::MatrixXd& a) {
      const Eigen::MatrixXd phi = explore_opt::testing::simulatedRegressor(problem, a) / cost(a);
      return Eigen::VectorXd(
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(unknownInformation(problem, phi))
              .eigenvalues());
    };
    const auto D = [&](const auto& a) { return information(a).array().log().sum(); };
    const auto A = [&](const auto& a) { return -information(a).cwiseInverse().sum(); };
    const auto E = [&](const auto& a) { return information(a)(0); };
    const Eigen::MatrixXd d = classicalDesign(problem, ClassicalCriterion::kD),
                          a = classicalDesign(problem, ClassicalCriterion::kA),
                          e = classicalDesign(problem, ClassicalCriterion::kE);
    for (const auto& design : {d, a, e}) {
      ASSERT_GT(design.size(), 0);
      EXPECT_NEAR(cost(design), 1.0, 1e-10);
    }
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Eigen::MatrixXd away =
          (i % 2 == 0 ? 1.0 : 1e-3) *
          randomMatrix(i, 5, static_cast<int>(d.rows()), static_cast<int>(d.cols()));
      EXPECT_GE(D(d), D(Eigen::MatrixXd(d + away)) - 1e-9);
      EXPECT_GE(A(a), A(Eigen::MatrixXd(a + away)) * (1 + 1e-9));
      // The gap of a design with both phases or one input; random directions are far from it.
      EXPECT_GE(E(e), E(Eigen::MatrixXd(e + away)) * (1 - 1e-5));
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

TEST(Baselines, CostsAreWhatTheDesignMinimises) {
  int number = 0;
  for (const ExplorationProblem& problem : kindsOfProblems()) {
    SCOPED_TRACE(number++);
    const DesignResult design = designExploration(problem);
    ASSERT_TRUE(design.feasible()) << design.message;
    BaselineOptions options;
    options.seeds = 2;
    const auto rows = compareBaselines(problem, design.amplitudes, options);
    // The design ends on the boundary by rounding; condition numbers here are below 1e3.
    EXPECT_NEAR(rows.front().cost, design.gamma_e, 1e-11 * design.gamma_e);
    // No other signal on the same carriers costs less than the proven bound.
    std::vector<std::string> same = {"D-optimal", "A-optimal", "E-optimal"};
    if (problem.phase == Phase::kBoth)
      same.insert(same.end(), {"multisine", "random_phase", "line"});
    for (const BaselineCost& row : rows) {
      if (std::find(same.begin(), same.end(), row.name) == same.end()) continue;
      EXPECT_GE(row.least, design.lower_bound * (1 - 1e-9)) << row.name;
    }
    if (problem.experiments == 1 && problem.D_des.size() == 1) {  // the same optimum
      EXPECT_NEAR(find(rows, "E-optimal").cost, design.gamma_e, 1e-4 * design.gamma_e);
    }
  }
}

TEST(Baselines, KnownEntriesLeaveFiniteCosts) {
  for (const char* const text : {kUnreachable, kTwins}) {
    const ExplorationProblem problem = fromText(text);
    const DesignResult design = designExploration(problem);
    for (const BaselineCost& row : compareBaselines(problem, design.amplitudes, {})) {
      EXPECT_TRUE(std::isfinite(row.cost)) << row.name;
      EXPECT_EQ(row.failed, 0) << row.name;
    }
  }
}

TEST(Baselines, AwayFromRestTheCheaperSignCounts) {
  ExplorationProblem problem = fromText(kFeedback);
  problem.x0 = Eigen::Vector2d(1.0, -0.3);
  const DesignResult design = designExploration(problem);
  ASSERT_TRUE(design.feasible()) << design.message;
  const auto rows = compareBaselines(problem, design.amplitudes, {});
  EXPECT_NEAR(rows.front().cost, design.gamma_e, 1e-9 * design.gamma_e);  // bisection: 1e-12
  const auto turned = compareBaselines(problem, -design.amplitudes, {});
  EXPECT_NEAR(turned.front().cost, rows.front().cost, 1e-9 * design.gamma_e);
  for (const std::string name : {"D-optimal", "A-optimal", "E-optimal", "multisine", "line"})
    EXPECT_GE(find(rows, name).cost, design.lower_bound * (1 - 1e-9)) << name;
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
