/// Unstable systems whose responses grow until doubles lose the digits that matter: an answer is
/// right, or there is none and the message says what grows and what to do.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "doubtful_answer.hpp"
#include "explore_opt/audit.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/exploration_design.hpp"
#include "explore_opt/predicted_response.hpp"
#include "quad_support/linear_algebra.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using explore_opt::testing::randomMatrix;

namespace {

/// T is such that ρ^T is 10^decades, ρ the spectral radius of A.
ExplorationProblem growing(const MatrixXd& A, const MatrixXd& B, double decades) {
  ExplorationProblem problem;
  problem.A = A;
  problem.B = B;
  const double radius = quad_support::spectralRadius(A);
  problem.lines = {static_cast<int>(decades / std::log10(radius)) + 1, {3, 7, 12}, {}};
  problem.phase = Phase::kCos;
  problem.gamma_w = 1.0;
  problem.D_des = MatrixXd::Identity(1, 1);
  return problem;
}

/// One unstable mode, one beside a stable one, a pair of different ones, a spiral.
std::vector<ExplorationProblem> family(double decades) {
  MatrixXd beside(2, 2), pair(2, 2), spiral(2, 2);
  beside << 1.1, 0.2, 0.0, 0.8;
  pair << 1.15, 0.1, 0.1, 1.1;
  spiral << 1.0, 0.4, -0.4, 1.0;
  const Eigen::Vector2d B(0.3, 1.0);
  return {growing(MatrixXd::Constant(1, 1, 1.2), MatrixXd::Ones(1, 1), decades),
          growing(beside, B, decades), growing(pair, B, decades), growing(spiral, B, decades)};
}

/// @returns whether there is an answer
bool isRightOrRefused(const ExplorationProblem& problem, DesignMethod method) {
  DesignOptions options;
  options.method = method;
  options.random_starts = 1;
  options.max_iterations = 20;
  const DesignResult result = designExploration(problem, options);
  if (!result.feasible()) {
    EXPECT_FALSE(result.message.empty());
    return false;
  }
  const AuditReport report =
      audit(problem, claimsFromJson(designToJson(problem, result).dump(), "design.json", problem));
  for (const AuditCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.finding;
  return true;
}

}  // namespace

TEST(Growth, AnAnswerIsRightOrThereIsNone) {
  for (const double decades : {6.0, 9.0, 11.0, 12.5}) {
    int answered = 0;
    for (const ExplorationProblem& problem : family(decades)) {
      for (const DesignMethod method : {DesignMethod::kGlobal, DesignMethod::kMm}) {
        SCOPED_TRACE(fmt::format("1e{}, A(0, 0) = {}, T = {}, {}", decades, problem.A(0, 0),
                                 problem.lines.num_samples, toString(method)));
        answered += isRightOrRefused(problem, method) ? 1 : 0;
      }
    }
    EXPECT_GE(answered, 4) << "1e" << decades;  // the refusal is not the rule yet
  }
}

TEST(Growth, TooMuchOfItIsRefused) {
  for (const double decades : {14.0, 16.0, 20.0, 60.0, 99.0, 300.0}) {
    for (ExplorationProblem problem : family(decades)) {
      SCOPED_TRACE(fmt::format("1e{}, A(0, 0) = {}", decades, problem.A(0, 0)));
      const DesignResult result = designExploration(problem);
      EXPECT_EQ(result.status, DesignStatus::kNumericalError);
      EXPECT_FALSE(result.feasible());
      EXPECT_NE(result.message.find("Stabilise with K"), std::string::npos) << result.message;
      problem.K = MatrixXd::Zero(1, problem.A.rows());
      EXPECT_NE(designExploration(problem).message.find("Choose a K that stabilises"),
                std::string::npos);
    }
  }
}

/// Six modes at random, two inputs.
ExplorationProblem sixModes(std::uint64_t seed, double decades) {
  MatrixXd A = randomMatrix(seed, 0, 6, 6);
  A *= 1.4 / quad_support::spectralRadius(A);
  return growing(A, randomMatrix(seed, 1, 6, 2), decades);
}

TEST(Growth, OfManyModesIsAuditedBeforeItIsAnswered) {
  int answered = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    answered += isRightOrRefused(sixModes(seed, 8.0), DesignMethod::kGlobal) ? 1 : 0;
  }
  EXPECT_GE(answered, 6);
}

/// Everything a problem may say, on one growing mode beside a stable one (and K that keeps it so).
std::vector<ExplorationProblem> allKinds(double decades) {
  const ExplorationProblem plain = family(decades)[1];
  std::vector<ExplorationProblem> kinds(9, plain);
  kinds[1].phase = Phase::kBoth;
  kinds[2].x0 = Eigen::Vector2d(0.3, -0.2);
  kinds[3].K = (MatrixXd(1, 2) << 0.1, -0.05).finished();
  kinds[3].A -= kinds[3].B * kinds[3].K;
  kinds[4] = kinds[3];
  if (decades < 8.0) kinds[4].cost = CostOn::kInput;  // beyond, the input's energy loses its rank
  kinds[5].known = MatrixXd::Constant(2, 3, NAN);
  kinds[5].known(1, 0) = 0.0;
  kinds[6].experiments = 2;
  kinds[7].D_des = (MatrixXd(3, 3) << 1.0, 0.2, 0.0, 0.2, 2.0, 0.1, 0.0, 0.1, 0.0).finished();
  kinds[7].D_des(2, 2) = 1.0;
  kinds[8].D_des = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
  for (const std::size_t i : {0, 2, 3, 4}) {  // the same again under a limit
    const DesignResult free = designExploration(kinds[i]);
    if (!free.feasible()) continue;
    kinds.push_back(kinds[i]);
    const double peak = predictedInputs(kinds[i], free.amplitudes).cwiseAbs().maxCoeff();
    kinds.back().u_max = Eigen::VectorXd::Constant(1, 0.97 * peak);
  }
  return kinds;
}

TEST(Growth, OfEveryKindOfProblem) {
  for (const double decades : {7.0, 9.0, 10.0}) {
    int answered = 0, kind = 0;
    for (const ExplorationProblem& problem : allKinds(decades)) {
      for (const DesignMethod method : {DesignMethod::kGlobal, DesignMethod::kMm}) {
        if (method == DesignMethod::kMm && problem.u_max.size() > 0) continue;
        SCOPED_TRACE(fmt::format("1e{}, kind {}, {}", decades, kind, toString(method)));
        answered += isRightOrRefused(problem, method) ? 1 : 0;
      }
      ++kind;
    }
    EXPECT_GE(answered, 12) << "1e" << decades;
  }
}

/// What the multiplier alone proves, in long double and by none of the solvers' code.
double provenBound(const ExplorationProblem& problem, const DesignResult& result) {
  DesignClaims claims;
  claims.amplitudes = MatrixXd::Zero(numCarriers(problem.lines, problem.phase), 1);
  claims.multiplier_root = result.multiplier_root;
  for (const PeakMultiplier& peak : result.peak_multipliers)
    claims.peak_multipliers.push_back({peak.sample, peak.input, peak.value});
  return audit(problem, claims).lower_bound;
}

TEST(Growth, InfeasibleIsProvenInMoreDigits) {
  int proven = 0;
  for (const double decades : {6.0, 8.0, 9.0}) {
    for (ExplorationProblem problem : family(decades)) {
      const double bound = designExploration(problem).lower_bound;
      problem.u_max = Eigen::VectorXd::Constant(1, 0.1 * bound);
      const DesignResult result = designExploration(problem);
      EXPECT_FALSE(result.feasible());
      if (result.status != DesignStatus::kInfeasible) continue;
      ++proven;
      // Cosines at three lines on the grid: γ_e² = 2/T Σ u_k², so no input within the limit costs
      // more than sqrt(2) u_max. What must cost more does not exist.
      EXPECT_GT(provenBound(problem, result), std::sqrt(2.0) * problem.u_max(0));
    }
  }
  EXPECT_GE(proven, 6);
}

TEST(Growth, WhatDoesNotStandIsWithdrawn) {
  const ExplorationProblem problem = family(9.0)[1];
  const DesignOptions options;
  const Doubt doubt = {"the ice is thin", "Walk around"};
  const DesignResult design = designExploration(problem);
  ASSERT_TRUE(design.feasible()) << design.message;

  DesignResult silent = design;  // amplitudes that excite nothing cannot be scaled up
  silent.amplitudes.setZero();
  const std::string of_amplitudes = auditAnswer(problem, options, doubt, silent);
  EXPECT_EQ(of_amplitudes,
            "the ice is thin, and the amplitudes found do not stand a simulation in more digits. "
            "Walk around");

  // Short by 1e-4 of the information: scaled up to where it was. The scale has rounding in it,
  // which growth raises from 1e-19 (long double) to 1e-10.
  DesignResult weak = design;
  weak.amplitudes *= 1.0 - 5e-5;
  weak.gamma_e *= 1.0 - 5e-5;
  EXPECT_EQ(auditAnswer(problem, options, doubt, weak), "");
  EXPECT_NEAR(weak.gamma_e / design.gamma_e, 1.0, 1e-8);
  EXPECT_GE(weak.lambda_min, 1.0 - 1e-9);

  DesignResult boastful = design;  // a bound that its multiplier does not prove
  boastful.amplitudes.resize(0, 0);
  boastful.lower_bound *= 1.01;
  const std::string of_bound = auditAnswer(problem, options, doubt, boastful);
  EXPECT_NE(of_bound.find("the bound found does not stand"), std::string::npos) << of_bound;
  EXPECT_NEAR(boastful.lower_bound / design.lower_bound, 1.0, 1e-6);
}

TEST(Growth, IsNamedWhereItHidesDirections) {
  const DesignResult result = designExploration(sixModes(1, 12.0));
  EXPECT_EQ(result.status, DesignStatus::kNotExciting);
  EXPECT_NE(result.message.find("the modes of A grow 1e+12-fold within T = 83"), std::string::npos)
      << result.message;
  EXPECT_NE(result.message.find("Stabilise with K"), std::string::npos) << result.message;
}

/// x_i(k+1) = x_i(k) + x_{i+1}(k), the input into the last.
ExplorationProblem integrators(int n, int T) {
  ExplorationProblem problem;
  problem.A = MatrixXd::Identity(n, n);
  problem.A.diagonal(1).setOnes();
  problem.B = Eigen::VectorXd::Unit(n, n - 1);
  problem.lines = {T, {3, 7, 11}, {}};
  problem.gamma_w = 2.0;
  problem.D_des = MatrixXd::Constant(1, 1, 4.0);
  return problem;
}

TEST(Growth, OfIntegratorsIsNoInstability) {
  ExplorationProblem problem = integrators(3, 100000);
  problem.lines.harmonics = {300, 700, 1200};
  EXPECT_EQ(designExploration(problem).message.find("unstable"), std::string::npos);
}

TEST(Growth, ResponsesThatCancelAreJudgedInMoreDigits) {
  // The states of single lines grow with T^4, their best sum does not: doubles put the cost of some
  // of these below its bound.
  for (const int n : {4, 5}) {
    for (const int T : {3000, 10000, 30000}) {
      SCOPED_TRACE(fmt::format("{} integrators, T = {}", n, T));
      EXPECT_TRUE(isRightOrRefused(integrators(n, T), DesignMethod::kGlobal));
      const DesignResult result = designExploration(integrators(n, T));
      EXPECT_EQ(result.status, DesignStatus::kSolved) << result.message;
      EXPECT_LE(result.gap, 1e-8);
    }
  }
}

TEST(Growth, OfTheStartIsNamedWhereItHidesWhatLinesAdd) {
  ExplorationProblem problem;
  problem.A = (MatrixXd(2, 2) << 0.9, 0.5, -0.5, 0.8).finished();
  problem.B = Eigen::Vector2d(1.0, 0.3);
  problem.K = (MatrixXd(1, 2) << 0.1, 0.2).finished();
  problem.lines = {60, {3, 7, 11}, {}};
  problem.gamma_w = 2.0;
  problem.D_des = MatrixXd::Constant(1, 1, 4.0);
  problem.x0 = 1e8 * Eigen::Vector2d(1.0, -0.5);
  const DesignResult result = designExploration(problem);
  EXPECT_EQ(result.status, DesignStatus::kNumericalError);
  EXPECT_NE(result.message.find("the response to x0 (norm 1.12e+08) outweighs"), std::string::npos)
      << result.message;
  problem.x0 *= 1e-6;
  EXPECT_TRUE(isRightOrRefused(problem, DesignMethod::kGlobal));
}
