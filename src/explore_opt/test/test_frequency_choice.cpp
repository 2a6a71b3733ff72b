/// Lines chosen by the frequency response.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "explore_opt/design_json.hpp"
#include "explore_opt/exploration_design.hpp"
#include "explore_opt/frequency_choice.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using explore_opt::testing::thesisProblem;

namespace {

ExplorationProblem flexibleStructure() {
  const std::string path = EXPLORE_OPT_EXAMPLES "/flexible_structure.json";
  return problemFromJson(quad_support::readFile(path), path);
}

}  // namespace

TEST(FrequencyChoice, PictureHasTheFrequencyResponse) {
  ExplorationProblem problem;
  problem.A = Eigen::MatrixXd::Constant(1, 1, 0.8);
  problem.B = (Eigen::MatrixXd(1, 2) << 0.5, -2.0).finished();
  problem.lines = {200, {1}, {}};
  problem.gamma_w = 1.0;
  problem.D_des = Eigen::MatrixXd::Identity(1, 1);
  const FrequencyChoice choice = chooseFrequencies(problem);
  ASSERT_EQ(choice.grid.size(), 99u);
  EXPECT_NEAR(choice.power.sum(), 1.0, 1e-12);
  for (std::size_t i = 0; i < choice.grid.size(); ++i) {
    const auto z = std::polar(1.0, 2.0 * M_PI * choice.grid[i] / 200.0);
    for (int j = 0; j < 2; ++j) {
      const std::complex<double> expected = problem.B(0, j) / (z - 0.8);
      EXPECT_NEAR(choice.gain(static_cast<int>(i), j), std::abs(expected), 1e-13);
      EXPECT_NEAR(choice.phase(static_cast<int>(i), j), std::arg(expected), 1e-13);
    }
  }
  EXPECT_EQ(choice.harmonics.size(), 3u);  // n_φ
}

TEST(FrequencyChoice, FindsTheModesAndPays) {
  ExplorationProblem problem = flexibleStructure();
  problem.D_des.diagonal().head(10).setConstant(1e4);  // all modes matter
  FrequencyOptions options;
  options.lines = 12;
  const FrequencyChoice choice = chooseFrequencies(problem, options);
  EXPECT_EQ(choice.harmonics.size(), 12u);
  for (const int mode : {20, 50, 90, 140, 200}) {  // the modes' harmonics; 2 % damping: ± 1 to ± 4
    bool near = false;
    for (const int h : choice.harmonics) near = near || std::abs(h - mode) <= 0.05 * mode;
    EXPECT_TRUE(near) << mode;
  }
  // As many lines evenly spaced cost more, whichever modes they happen to meet.
  ExplorationProblem other = problem;
  other.lines.harmonics = choice.harmonics;
  const double chosen = designExploration(other).gamma_e;
  for (const int first : {10, 20}) {
    other.lines.harmonics.clear();
    for (int h = first; other.lines.size() < 12; h += 20) other.lines.harmonics.push_back(h);
    EXPECT_LT(chosen, designExploration(other).gamma_e) << first;
  }
}

TEST(FrequencyChoice, KeepsToTheBandAndTheNumberOfLines) {
  FrequencyOptions options;
  options.band_low = 0.03;
  options.band_high = 0.1;
  for (const int lines : {1, 5, 30, 200}) {
    options.lines = lines;
    const FrequencyChoice choice = chooseFrequencies(flexibleStructure(), options);
    EXPECT_EQ(choice.harmonics.size(), static_cast<std::size_t>(std::min(lines, 71)));
    EXPECT_GE(choice.harmonics.front(), 30);
    EXPECT_LE(choice.harmonics.back(), 100);
    double sum = 0.0;
    for (const double share : choice.shares) sum += share;
    EXPECT_NEAR(sum, 1.0, 1e-12);
    for (std::size_t i = 1; i < choice.harmonics.size(); ++i)
      EXPECT_LT(choice.harmonics[i - 1], choice.harmonics[i]);
  }
}

TEST(FrequencyChoice, ThinsALongGrid) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.lines = {1000000, {1}, {}};
  const FrequencyChoice choice = chooseFrequencies(problem);
  EXPECT_LT(choice.grid.size(), 1100u);
  EXPECT_GT(choice.grid.size(), 500u);
  EXPECT_EQ(choice.grid.front(), 1);
}

TEST(FrequencyChoice, SpreadsLinesOverABroadSpectrum) {
  ExplorationProblem problem;  // one pole: the spectrum has its only peak at the lowest harmonic
  problem.B = Eigen::MatrixXd::Ones(1, 1);
  problem.gamma_w = 1.0;
  problem.D_des = Eigen::MatrixXd::Constant(1, 1, 10.0);
  for (const double pole : {0.5, 0.7, 0.9}) {
    problem.A = Eigen::MatrixXd::Constant(1, 1, pole);
    problem.lines = {100, {1}, {}};
    problem.lines.harmonics = chooseFrequencies(problem).harmonics;
    // sqrt(2 γ_w λ/T) is what the information on B costs with any lines; neighbours of the peak
    // cost 1.2 to 3.6 times as much.
    EXPECT_LT(designExploration(problem).gamma_e, 1.01 * std::sqrt(2.0 * 10.0 / 100.0)) << pole;
  }
}

TEST(FrequencyChoice, LooksAtUnknownEntriesAlone) {
  ExplorationProblem alone;  // x+ = 0.9 x + u
  alone.A = Eigen::MatrixXd::Constant(1, 1, 0.9);
  alone.B = Eigen::MatrixXd::Ones(1, 1);
  alone.lines = {100, {1}, {}};
  alone.gamma_w = 1.0;
  alone.D_des = Eigen::MatrixXd::Constant(1, 1, 10.0);
  ExplorationProblem beside = alone;  // and a state that no input moves
  beside.A = Eigen::Vector2d(0.9, 0.5).asDiagonal();
  beside.B = Eigen::Vector2d(1.0, 0.0);
  EXPECT_THROW(chooseFrequencies(beside), quad_support::NegativeAnswer);
  beside.known = (Eigen::MatrixXd(2, 3) << NAN, 0, NAN, 0, 0.5, 0).finished();
  FrequencyOptions options;
  options.lines = 2;
  const FrequencyChoice expected = chooseFrequencies(alone, options);
  for (const bool full : {false, true}) {
    if (full) beside.D_des = 10.0 * Eigen::MatrixXd::Identity(6, 6);
    const FrequencyChoice choice = chooseFrequencies(beside, options);
    EXPECT_EQ(choice.harmonics, expected.harmonics);
    // The known state adds zeros to sums, which moves nothing but rounding.
    EXPECT_LT((choice.power - expected.power).cwiseAbs().maxCoeff(), 1e-12);
  }
  beside.known(1, 1) = NAN;  // the state nobody moves is asked for after all
  EXPECT_THROW(chooseFrequencies(beside), quad_support::NegativeAnswer);

  ExplorationProblem twins = alone;  // states that are always equal, told apart by what is known
  twins.A = Eigen::Vector2d(0.5, 0.5).asDiagonal();
  twins.B = Eigen::Vector2d(1.0, 1.0);
  twins.known = (Eigen::MatrixXd(2, 3) << NAN, 0, NAN, 0, NAN, NAN).finished();
  twins.lines.harmonics = chooseFrequencies(twins).harmonics;
  EXPECT_EQ(twins.lines.harmonics.size(), 3u);
  EXPECT_TRUE(designExploration(twins).feasible());
}

TEST(FrequencyChoice, SaysWhyItCannotChoose) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  problem.A(1, 1) = 1.05;
  EXPECT_THROW(chooseFrequencies(problem), quad_support::NegativeAnswer);
  problem.K = (Eigen::MatrixXd(1, 2) << -0.5, -1.0).finished();
  EXPECT_NO_THROW(chooseFrequencies(problem));
  problem = thesisProblem(Phase::kCos);
  problem.B.setZero();
  EXPECT_THROW(chooseFrequencies(problem), quad_support::NegativeAnswer);
  FrequencyOptions options;
  options.band_high = 1e-4;
  EXPECT_THROW(chooseFrequencies(thesisProblem(Phase::kCos), options), quad_support::DataError);
  options = {};
  options.lines = -1;
  EXPECT_THROW(chooseFrequencies(thesisProblem(Phase::kCos), options), quad_support::DataError);
}
