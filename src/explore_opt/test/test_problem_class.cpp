/// Everything beyond a stable system at rest: start, feedback, known entries, peak limits, singular
/// closeness, several experiments, long and growing horizons. Each judged by plain simulation.
#include <gtest/gtest.h>

#include <cmath>

#include "explore_opt/exploration_design.hpp"
#include "explore_opt/predicted_response.hpp"
#include "quad_support/errors.hpp"
#include "raw_audit.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using explore_opt::testing::kroneckerIdentity;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::rawBound;
using explore_opt::testing::rawLambdaMin;
using explore_opt::testing::rawRegressor;
using explore_opt::testing::simulatedRegressor;
using explore_opt::testing::thesisProblem;
using quad_support::DataError;

namespace {

DesignOptions byMajorisation() {
  DesignOptions options;
  options.method = DesignMethod::kMm;
  return options;
}

/// What an answer claims, from the raw data: feasible, and no amplitudes cheaper than its bound.
void audit(const ExplorationProblem& problem, const DesignResult& result) {
  ASSERT_TRUE(result.feasible()) << result.message;
  EXPECT_GE(rawLambdaMin(problem, result.amplitudes), 1.0 - 1e-9);  // the acceptance of the design
  EXPECT_LE(result.lower_bound, result.gamma_e);
  // The bound is the value of an unconstrained quadratic; its terms cancel to about 1e-9.
  EXPECT_NEAR(rawBound(problem, result), result.lower_bound, 1e-7 * result.gamma_e);
}

ExplorationProblem twoInputs() {
  ExplorationProblem problem;
  problem.A = (MatrixXd(2, 2) << 0.8, 0.2, -0.1, 0.7).finished();
  problem.B = (MatrixXd(2, 2) << 1.0, 0.3, -0.4, 0.8).finished();
  problem.lines = {100, {2, 7, 13, 24}, {}};
  problem.gamma_w = 1.0;
  problem.D_des = MatrixXd::Constant(1, 1, 50.0);
  return problem;
}

double inputRms(const ExplorationProblem& problem, const MatrixXd& amplitudes) {
  return std::sqrt(2.0 / problem.lines.num_samples *
                   predictedInputs(problem, amplitudes).squaredNorm());
}

}  // namespace

TEST(StartAwayFromRest, IsCertified) {
  for (const VectorXd& x0 :
       {VectorXd(Eigen::Vector2d(1.0, 0.5)), VectorXd(Eigen::Vector2d(-40, 3))}) {
    ExplorationProblem problem = thesisProblem(Phase::kCos);
    problem.x0 = x0;
    const DesignResult result = designExploration(problem);
    EXPECT_EQ(result.status, DesignStatus::kSolved);
    EXPECT_LE(result.gap, 1e-6);
    audit(problem, result);
  }
}

TEST(StartAwayFromRest, ZeroIsTheSameAsNone) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  const double none = designExploration(problem).gamma_e;
  problem.x0 = Eigen::Vector2d(0, 0);
  EXPECT_EQ(designExploration(problem).gamma_e, none);
  problem.x0 = Eigen::Vector2d(1e-9, 0);  // the other code path, next to no start
  EXPECT_NEAR(designExploration(problem).gamma_e, none, 1e-7 * none);
}

TEST(StartAwayFromRest, MajorisationReachesTheBound) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.x0 = Eigen::Vector2d(1.0, 0.5);
  const DesignResult global = designExploration(problem),
                     mm = designExploration(problem, byMajorisation());
  EXPECT_EQ(mm.status, DesignStatus::kSolved) << mm.message;
  EXPECT_GE(mm.gamma_e, global.lower_bound);
  EXPECT_LE(mm.gamma_e, 1.001 * global.gamma_e);
  audit(problem, mm);
}

TEST(StartAwayFromRest, MayBeExcitingEnoughByItself) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.K = (MatrixXd(1, 2) << -1.5, -2.0).finished();
  problem.x0 = Eigen::Vector2d(3e3, 1e3);
  for (const DesignOptions& options : {DesignOptions(), byMajorisation()}) {
    const DesignResult result = designExploration(problem, options);
    // x and K x are collinear in closed loop: the start alone cannot tell A from B K.
    EXPECT_GT(result.gamma_e, 0.0);
  }
  problem.known = MatrixXd::Constant(2, 3, NAN);
  for (int i = 0; i < 2; ++i) problem.known(i, 2) = problem.B(i, 0);
  for (const DesignOptions& options : {DesignOptions(), byMajorisation()}) {
    const DesignResult result = designExploration(problem, options);  // with B known it can
    EXPECT_EQ(result.status, DesignStatus::kSolved);
    EXPECT_EQ(result.gamma_e, 0.0);
    EXPECT_EQ(result.gap, 0.0);
    EXPECT_GE(rawLambdaMin(problem, result.amplitudes), 1.0);
  }
}

TEST(Feedback, CostOnTheSignalOrOnTheInput) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.K = (MatrixXd(1, 2) << -1.5, -2.0).finished();
  const DesignResult signal = designExploration(problem);
  audit(problem, signal);
  EXPECT_LE(signal.gap, 1e-5);
  problem.cost = CostOn::kInput;
  const DesignResult input = designExploration(problem);
  audit(problem, input);
  EXPECT_LE(input.gap, 1e-5);
  EXPECT_NEAR(inputRms(problem, input.amplitudes), input.gamma_e, 1e-9 * input.gamma_e);
  // Each is the best in its own measure.
  EXPECT_LE(signal.gamma_e, input.amplitudes.norm() * (1.0 + 1e-6));
  EXPECT_LE(input.gamma_e, inputRms(problem, signal.amplitudes) * (1.0 + 1e-6));
  // Open loop and closed loop ask the same of the input: grid lines, and nearly no transients.
  problem.x0 = Eigen::Vector2d(2.0, 0.0);
  const DesignResult moved = designExploration(problem);
  audit(problem, moved);
  EXPECT_NEAR(inputRms(problem, moved.amplitudes), moved.gamma_e, 1e-9 * moved.gamma_e);
}

TEST(Feedback, CostOnTheInputIsTheSameOnTheGridWithoutIt) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  const double signal = designExploration(problem).gamma_e;
  problem.cost = CostOn::kInput;
  EXPECT_NEAR(designExploration(problem).gamma_e, signal, 1e-8 * signal);
  EXPECT_NEAR(designExploration(problem, byMajorisation()).gamma_e, signal, 1e-4 * signal);
}

TEST(KnownEntries, NeedLessInput) {
  ExplorationProblem problem = thesisProblem(Phase::kSin);
  const double all = designExploration(problem).gamma_e;
  problem.known = (MatrixXd(2, 3) << 1, NAN, NAN, 0, 1, NAN).finished();  // A12, B1, B2 unknown
  const DesignResult kronecker = designExploration(problem);
  audit(problem, kronecker);
  EXPECT_LE(kronecker.gap, 1e-5);
  EXPECT_LE(kronecker.gamma_e, all * (1.0 + 1e-9));
  problem.D_des = 100.0 * MatrixXd::Identity(6, 6);  // the same, asked for in full
  const DesignResult full = designExploration(problem);
  audit(problem, full);
  EXPECT_NEAR(full.gamma_e, kronecker.gamma_e, 1e-6 * full.gamma_e);
  problem.known = MatrixXd::Constant(2, 3, NAN);
  problem.D_des = MatrixXd::Constant(1, 1, 100.0);
  EXPECT_NEAR(designExploration(problem).gamma_e, all, 1e-9 * all);
}

TEST(SingularCloseness, OnlyWhatIsAskedForCounts) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.D_des = Eigen::Vector3d(0.0, 0.0, 100.0).asDiagonal();  // B alone
  const DesignResult input = designExploration(problem);
  EXPECT_LE(input.gap, 1e-3);  // what the floor of 1e-6 D in the kernel costs
  audit(problem, input);
  // Between the input block's bound and the optimum that asks for all of it.
  EXPECT_GE(input.gamma_e, 3.28798);
  EXPECT_LE(input.gamma_e, 3.31938);
  MatrixXd full = MatrixXd::Zero(6, 6);
  full(2, 2) = 50.0;  // A12 alone
  problem.D_des = full;
  const DesignResult one = designExploration(problem);
  audit(problem, one);
  EXPECT_LT(one.gamma_e, input.gamma_e);
  EXPECT_LE(one.gap, 0.5);
}

TEST(PeakLimit, IsKeptAndCertified) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  const DesignResult free = designExploration(problem);
  const double peak = predictedInputs(problem, free.amplitudes).cwiseAbs().maxCoeff();
  for (const double part : {1.2, 0.9, 0.8}) {
    SCOPED_TRACE(part);
    problem.u_max = VectorXd::Constant(1, part * peak);
    const DesignResult result = designExploration(problem);
    audit(problem, result);
    EXPECT_LE(predictedInputs(problem, result.amplitudes).cwiseAbs().maxCoeff(),
              part * peak * (1.0 + 1e-9));
    EXPECT_GE(result.gamma_e, free.gamma_e * (1.0 - 1e-9));
    EXPECT_LE(result.gap, part > 1.0 ? 1e-6 : 0.05);
    if (part > 1.0) {
      EXPECT_NEAR(result.gamma_e, free.gamma_e, 1e-9);
    }
  }
}

TEST(PeakLimit, TooSmallIsProvenInfeasible) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.u_max = VectorXd::Constant(1, 1.0);  // the RMS input alone must be 3.29/√2
  const DesignResult result = designExploration(problem);
  EXPECT_EQ(result.status, DesignStatus::kInfeasible);
  EXPECT_FALSE(result.feasible());
  EXPECT_NE(result.message.find("u_max is too small"), std::string::npos) << result.message;
  EXPECT_GT(result.lower_bound, std::sqrt(2.0) * 1.0);
}

/// Three states and two inputs, whose cheapest design has a peak of 1.04.
ExplorationProblem threeStates(double u_max) {
  ExplorationProblem problem;
  problem.A = (MatrixXd(3, 3) << 0.9, 0.2, 0.0, -0.1, 0.8, 0.1, 0.0, 0.1, 0.7).finished();
  problem.B = (MatrixXd(3, 2) << 1.0, 0.0, 0.0, 1.0, 0.3, -0.2).finished();
  problem.lines = {200, {5, 17, 40, 61}, {}};
  problem.phase = Phase::kCos;
  problem.gamma_w = 2.0;
  problem.D_des = MatrixXd::Constant(1, 1, 10.0);
  problem.u_max = VectorXd::Constant(1, u_max);
  return problem;
}

double largestInput(const ExplorationProblem& problem, const MatrixXd& amplitudes) {
  return predictedInputs(problem, amplitudes).colwise().norm().maxCoeff();
}

/// Feasible, within the limit, and not dearer than a design known to be, but for half a per cent.
void expectAsGoodAs(const ExplorationProblem& problem, double known_cost) {
  const DesignResult result = designExploration(problem);
  ASSERT_TRUE(result.feasible()) << result.message;
  audit(problem, result);
  EXPECT_LE(largestInput(problem, result.amplitudes), problem.u_max(0) * (1.0 + 1e-9));
  EXPECT_LE(result.gamma_e, 1.005 * known_cost);
}

TEST(PeakLimit, LittleRoomIsFound) {  // costs of designs found by hand within these limits
  expectAsGoodAs(threeStates(1.0), 1.0616);
  ExplorationProblem thesis = thesisProblem(Phase::kSin);
  thesis.lines.harmonics = {3, 9, 15};
  thesis.u_max = VectorXd::Constant(1, 3.2);
  expectAsGoodAs(thesis, 3.31595);
}

TEST(PeakLimit, HoldsFromAStartInMotion) {  // the feedback's share of the input counts
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.K = (MatrixXd(1, 2) << -1.5, -2.0).finished();
  problem.x0 = Eigen::Vector2d(2.0, 0.0);
  for (const CostOn cost : {CostOn::kSignal, CostOn::kInput}) {
    SCOPED_TRACE(static_cast<int>(cost));
    problem.cost = cost;
    problem.u_max.resize(0);
    const DesignResult free = designExploration(problem);
    problem.u_max = VectorXd::Constant(1, 0.93 * largestInput(problem, free.amplitudes));
    const DesignResult result = designExploration(problem);
    audit(problem, result);
    EXPECT_LE(largestInput(problem, result.amplitudes), problem.u_max(0) * (1.0 + 1e-9));
    EXPECT_GE(result.gamma_e, free.gamma_e * (1.0 - 1e-9));
  }
}

TEST(PeakLimit, APlantedDesignIsMatched) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    ExplorationProblem problem = threeStates(1.0);
    problem.u_max.resize(0);
    problem.A = randomMatrix(seed, 0, 3, 3);
    problem.A *= 0.8 / problem.A.norm();
    problem.B = randomMatrix(seed, 1, 3, 2);
    MatrixXd planted;  // of the lowest peak among many on the boundary
    double peak = 0.0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      MatrixXd a = randomMatrix(seed, 2 + i, 4, 2);
      a *= scaledCost(problem, a) / a.norm();
      const double now = largestInput(problem, a);
      if (i > 0 && now >= peak) continue;
      peak = now;
      planted = a;
    }
    problem.u_max = VectorXd::Constant(1, 1.001 * peak);
    expectAsGoodAs(problem, planted.norm());
  }
}

TEST(PeakLimit, TheBoundIsNeverBelowTheOneWithoutIt) {
  ExplorationProblem problem = thesisProblem(Phase::kSin);
  const DesignResult free = designExploration(problem);
  problem.u_max = VectorXd::Constant(1, 2.0);
  const DesignResult none = designExploration(problem);
  EXPECT_EQ(none.status, DesignStatus::kInfeasible);
  EXPECT_GE(none.lower_bound, free.lower_bound);
  problem.u_max =
      VectorXd::Constant(1, 3.0);  // large enough for the energy, too small for the peak
  const DesignResult undecided = designExploration(problem);
  EXPECT_FALSE(undecided.feasible());
  EXPECT_GE(undecided.lower_bound, free.lower_bound);
  EXPECT_NE(undecided.message.find("least peak"), std::string::npos) << undecided.message;
}

TEST(PeakLimit, IsNotSolvedForSeveralExperimentsNorAreTheyAdvised) {
  ExplorationProblem problem = threeStates(1.1);  // holds at the optimum without it
  const DesignResult result = designExploration(problem);
  ASSERT_GT(result.relaxation_rank, 1);
  EXPECT_EQ(result.message.find("experiments"), std::string::npos) << result.message;
  problem.experiments = result.relaxation_rank;
  EXPECT_THROW(designExploration(problem), DataError);
}

TEST(PeakLimit, OnTheNormAndOnEachInput) {
  ExplorationProblem problem = twoInputs();
  problem.phase = Phase::kBoth;
  const DesignResult free = designExploration(problem);
  const MatrixXd u = predictedInputs(problem, free.amplitudes);
  problem.u_max = VectorXd::Constant(1, 0.93 * u.colwise().norm().maxCoeff());
  const DesignResult norm = designExploration(problem);
  audit(problem, norm);
  EXPECT_LE(predictedInputs(problem, norm.amplitudes).colwise().norm().maxCoeff(),
            problem.u_max(0) * (1.0 + 1e-9));
  problem.u_max = 0.93 * u.cwiseAbs().rowwise().maxCoeff();
  const DesignResult each = designExploration(problem);
  audit(problem, each);
  for (int j = 0; j < 2; ++j) {
    EXPECT_LE(predictedInputs(problem, each.amplitudes).row(j).cwiseAbs().maxCoeff(),
              problem.u_max(j) * (1.0 + 1e-9));
  }
  DesignOptions mm = byMajorisation();
  EXPECT_THROW(designExploration(problem, mm), DataError);
}

TEST(Experiments, MeetTheBoundWhereOneCannot) {
  ExplorationProblem problem = twoInputs();
  problem.A = (MatrixXd(2, 2) << 0.9, 0.3, -0.2, 0.5).finished();
  problem.B = (MatrixXd(2, 2) << 1.0, 0.2, 0.3, 1.0).finished();
  problem.lines.harmonics = {3, 40};  // two lines of one phase for two inputs: the bound is far off
  const DesignResult one = designExploration(problem);
  ASSERT_GT(one.gap, 1e-3);
  ASSERT_GT(one.relaxation_rank, 1);
  EXPECT_NE(one.message.find("\"experiments\": "), std::string::npos) << one.message;
  problem.experiments = one.relaxation_rank;
  const DesignResult several = designExploration(problem);
  ASSERT_TRUE(several.feasible()) << several.message;
  EXPECT_LE(several.gap, 1e-5);
  EXPECT_NEAR(several.lower_bound, one.lower_bound, 1e-6 * one.lower_bound);
  // Grams of the runs add, and so does the disturbance: Σ Q_i ⪰ r γ_w D.
  const int r = problem.experiments, rows = static_cast<int>(several.amplitudes.rows()) / r;
  MatrixXd sum = MatrixXd::Zero(4, 4);
  for (int i = 0; i < r; ++i) {
    const MatrixXd phi = simulatedRegressor(problem, several.amplitudes.middleRows(i * rows, rows));
    sum += phi * phi.transpose();
  }
  EXPECT_GE(explore_opt::testing::smallestEigenvalue(sum) / (r * 50.0), 1.0 - 1e-9);
  EXPECT_NEAR(several.amplitudes.norm() / std::sqrt(r), several.gamma_e, 1e-12);
}

TEST(Horizon, TheTriangleEqualsTheSimulation) {  // every doubling and every odd step
  for (const int T : {7, 20, 64, 65, 127, 370, 1001}) {
    SCOPED_TRACE(T);
    ExplorationProblem problem = twoInputs();
    problem.A = (MatrixXd(2, 2) << 1.0, 0.3, 0.0, 1.0).finished();  // a double integrator
    problem.lines = {T, {1, 3}, {}};
    problem.phase = Phase::kBoth;
    problem.x0 = Eigen::Vector2d(0.3, -0.2);
    const PredictedResponse response = predictResponse(problem);
    const MatrixXd amplitudes = randomMatrix(5, 0, 4, 2);
    const VectorXd a = amplitudes.reshaped<Eigen::RowMajor>();
    const MatrixXd phi = rawRegressor(problem, amplitudes).cast<double>();
    const MatrixXd N = phi * phi.transpose() / 50.0;
    const MatrixXd scale = N.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    EXPECT_LT((scale * (response.information(a) - N) * scale).norm(), 1e-11);  // T eps
    EXPECT_LE(response.offset.rows(), 2 + 2 * 2);                              // n_x + 2 L
  }
}

TEST(Horizon, AMillionSamples) {
  ExplorationProblem problem = thesisProblem(Phase::kCos, 1'000'000);
  problem.lines.harmonics = {8108, 16216, 21622, 27027};
  problem.A(1, 1) = 0.999;
  problem.A(0, 0) = 0.99;
  const DesignResult result = designExploration(problem);
  EXPECT_EQ(result.status, DesignStatus::kSolved);
  EXPECT_LE(result.gap, 1e-6);
  EXPECT_GE(explore_opt::testing::simulatedLambdaMin(problem, result.amplitudes), 1.0 - 1e-6);
}

TEST(Horizon, GrowthBeyondDoublesIsANegativeAnswer) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.A *= 5.0;
  for (const DesignOptions& options : {DesignOptions(), byMajorisation()}) {
    const DesignResult result = designExploration(problem, options);
    EXPECT_EQ(result.status, DesignStatus::kNumericalError);
    EXPECT_NE(result.message.find("Stabilise with K"), std::string::npos) << result.message;
  }
  problem.K = (MatrixXd(1, 2) << -96.74673849, -26.8601896).finished();  // poles 0.5, 0.4
  ASSERT_LT((problem.A + problem.B * problem.K).eigenvalues().cwiseAbs().maxCoeff(), 1.0);
  EXPECT_NE(designExploration(problem).status, DesignStatus::kNumericalError);
}

TEST(Majorisation, BothPhasesAreReached) {
  const ExplorationProblem problem = thesisProblem(Phase::kBoth);
  const DesignResult global = designExploration(problem),
                     mm = designExploration(problem, byMajorisation());
  audit(problem, mm);
  EXPECT_LE(mm.gamma_e, 1.001 * global.gamma_e);
}
