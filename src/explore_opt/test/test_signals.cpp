#include <gtest/gtest.h>

#include <cmath>

#include "explore_opt/exploration_signal.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using quad_support::DataError;

namespace {

const SpectralLines kThesisLines{370, {3, 6, 8, 10}, {}};

Eigen::MatrixXd thesisAmplitudes() { return Eigen::Vector4d(0.04, 0.94, 1.76, -2.62); }

std::string messageOf(const SpectralLines& lines) {
  try {
    validate(lines);
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(Multisine, EnergyOnTheGridIsHalfTTimesSumOfSquares) {
  for (const Phase phase : {Phase::kSin, Phase::kCos, Phase::kBoth}) {
    for (const int inputs : {1, 3}) {
      const Eigen::MatrixXd amplitudes =
          explore_opt::testing::randomMatrix(7, 0, numCarriers(kThesisLines, phase), inputs);
      const double expected = 370.0 / 2.0 * amplitudes.squaredNorm();
      // Orthogonality of the lines: 370 terms, each rounded to 1e-16.
      EXPECT_NEAR(signalEnergy(multisine(kThesisLines, phase, amplitudes)), expected,
                  1e-13 * expected);
    }
  }
}

TEST(Multisine, EnergyOfTheThesisSignal) {
  const double ours = signalEnergy(multisine(kThesisLines, Phase::kSin, thesisAmplitudes()));
  EXPECT_NEAR(ours, 185.0 * (0.04 * 0.04 + 0.94 * 0.94 + 1.76 * 1.76 + 2.62 * 2.62), 1e-9);
  // The amplitudes are printed to 0.01, so their sum of squares carries up to 2 · 0.005 Σ|α|
  // of 10.85: 0.5 %.
  EXPECT_NEAR(ours, 2012.0, 0.005 * 2012.0);
}

TEST(Multisine, PeakIsNotBoundedByTheNorm) {
  const Eigen::MatrixXd u = multisine(kThesisLines, Phase::kSin, thesisAmplitudes());
  EXPECT_GT(u.cwiseAbs().maxCoeff(), 1.1 * thesisAmplitudes().norm());
}

TEST(Multisine, SamplesByHand) {
  const SpectralLines lines{8, {1, 2}, {}};
  const Eigen::MatrixXd amplitudes = Eigen::Vector2d(1.0, 10.0);
  const double r = std::sqrt(0.5);
  const Eigen::MatrixXd sines = multisine(lines, Phase::kSin, amplitudes),
                        cosines = multisine(lines, Phase::kCos, amplitudes);
  for (const auto& [k, s, c] : {std::tuple{0, 0.0, 11.0},
                                {1, r + 10.0, r},
                                {2, 1.0, -10.0},
                                {3, r - 10.0, -r},
                                {4, 0.0, 9.0}}) {
    EXPECT_NEAR(sines(0, k), s, 1e-14) << k;
    EXPECT_NEAR(cosines(0, k), c, 1e-14) << k;
  }
}

TEST(Multisine, PhaseStaysExactFarOut) {
  // After a whole number of periods the carrier repeats bit for bit, and quarter turns are exact.
  const SpectralLines lines{4'000'000, {1'000'000, 3}, {}};
  const Eigen::MatrixXd wave = carriers(lines, Phase::kSin);
  for (const int k : {0, 399'996, 3'999'996}) {
    EXPECT_EQ(wave(0, k), 0.0);
    EXPECT_EQ(wave(0, k + 1), 1.0);
    EXPECT_EQ(wave(0, k + 2), 0.0);
    EXPECT_EQ(wave(0, k + 3), -1.0);
  }
  EXPECT_EQ(wave(1, 1), -wave(1, 3'999'999));
}

TEST(Multisine, FrequenciesAndHarmonicsAgree) {
  SpectralLines frequencies{370, {}, {}};
  for (const int h : kThesisLines.harmonics) frequencies.frequencies.push_back(h / 370.0);
  // h/370 is rounded to 1e-17; times k = 369 that is 1e-14 of a turn.
  EXPECT_LT((carriers(frequencies, Phase::kBoth) - carriers(kThesisLines, Phase::kBoth))
                .cwiseAbs()
                .maxCoeff(),
            1e-13);
}

TEST(SpectralLines, RefusesWhatIsNoLine) {
  EXPECT_EQ(messageOf({370, {3, 6, 200, 10}, {}}),
            "harmonics[2] = 200; must lie in 1..184 (below T/2, T = 370)");
  EXPECT_NE(messageOf({370, {0}, {}}), "");
  EXPECT_NE(messageOf({370, {185}, {}}), "");  // T/2: the sine vanishes
  EXPECT_EQ(messageOf({370, {184}, {}}), "");
  EXPECT_EQ(messageOf({371, {185}, {}}), "");  // below 185.5
  EXPECT_EQ(messageOf({370, {3, 6, 3}, {}}), "harmonics[2] = 3 stands in the list already (at 0)");
  EXPECT_NE(messageOf({370, {}, {0.5}}), "");
  EXPECT_NE(messageOf({370, {}, {0.9}}), "");  // the mirror of 0.1
  EXPECT_NE(messageOf({370, {}, {NAN}}), "");
  EXPECT_NE(messageOf({370, {3}, {0.1}}), "");
  EXPECT_NE(messageOf({370, {}, {}}), "");
  EXPECT_NE(messageOf({0, {1}, {}}), "");
  EXPECT_THROW(multisine(kThesisLines, Phase::kBoth, thesisAmplitudes()),
               DataError);  // eight carriers, four rows
}

TEST(GaussianSignal, HasTheEnergyAndItsAddress) {
  const Eigen::MatrixXd u = gaussianSignal(2006.7, 1, 370, 1, 0, 5);
  EXPECT_NEAR(signalEnergy(u), 2006.7, 1e-10);
  EXPECT_EQ(u, gaussianSignal(2006.7, 1, 370, 1, 0, 5));
  EXPECT_NE(u, gaussianSignal(2006.7, 1, 370, 2, 0, 5));
  EXPECT_NE(u, gaussianSignal(2006.7, 1, 370, 1, 1, 5));
  EXPECT_NE(u, gaussianSignal(2006.7, 1, 370, 1, 0, 6));
  EXPECT_EQ(signalEnergy(gaussianSignal(0.0, 2, 10, 1, 0, 0)), 0.0);
  EXPECT_THROW(gaussianSignal(-1.0, 1, 370, 1, 0, 5), DataError);
}

TEST(Phase, TextRoundTrip) {
  for (const Phase phase : {Phase::kSin, Phase::kCos, Phase::kBoth})
    EXPECT_EQ(phaseFromString(toString(phase)), phase);
  EXPECT_THROW(phaseFromString("sine"), DataError);
}
