/// Spectrum, levels, period and energy of the signals a design is compared with.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>

#include "explore_opt/baseline_signals.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/linear_algebra.hpp"

using namespace explore_opt;
using quad_support::DataError;

namespace {

BaselineSpec specOf(BaselineKind kind, int inputs = 1, int T = 370) {
  BaselineSpec spec;
  spec.kind = kind;
  spec.num_samples = T;
  spec.num_inputs = inputs;
  spec.energy = 2006.7;
  spec.seed = 11;
  spec.stream = 3;
  spec.lines = {T, {3, 6, 8, 10}, {}};
  return spec;
}

/// Σ_k u_k e^{-2πjhk/T} by its definition.
std::complex<double> dft(const Eigen::RowVectorXd& u, int h) {
  std::complex<double> sum;
  const auto T = static_cast<int>(u.size());
  for (int k = 0; k < T; ++k) sum += u(k) * std::polar(1.0, -2.0 * M_PI * ((h * k) % T) / T);
  return sum;
}

/// Largest part of the signal's energy outside the given harmonics.
double strayEnergy(const Eigen::RowVectorXd& u, const std::set<int>& harmonics) {
  const auto T = static_cast<int>(u.size());
  double stray = std::norm(dft(u, 0)) / T;
  for (int h = 1; 2 * h <= T; ++h) {
    if (harmonics.count(h) == 0) stray += 2.0 * std::norm(dft(u, h)) / T;
  }
  return stray / u.squaredNorm();
}

// A sum of 370 products rounded to 1e-16 each, squared: far below 1e-24 of the energy.
constexpr double kNoise = 1e-24;

std::string messageOf(const BaselineSpec& spec) {
  try {
    baselineSignal(spec);
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(BaselineSignals, HaveTheEnergyShapeAndSeed) {
  for (const BaselineKind kind : allBaselines()) {
    for (const int inputs : {1, 2, 3}) {
      SCOPED_TRACE(toString(kind));
      BaselineSpec spec = specOf(kind, inputs);
      const Eigen::MatrixXd U = baselineSignal(spec);
      EXPECT_EQ(U.rows(), inputs);
      EXPECT_EQ(U.cols(), 370);
      EXPECT_NEAR(signalEnergy(U), 2006.7, 1e-10);  // 370 squares rounded to 1e-16
      EXPECT_EQ(U, baselineSignal(spec));
      ++spec.seed;
      EXPECT_EQ(U != baselineSignal(spec), isRandom(kind));
      spec.energy = 0.0;
      EXPECT_EQ(signalEnergy(baselineSignal(spec)), 0.0);
    }
  }
}

TEST(BaselineSignals, NamesRoundTrip) {
  for (const BaselineKind kind : allBaselines())
    EXPECT_EQ(baselineFromString(toString(kind)), kind);
  try {
    baselineFromString("noise");
    FAIL();
  } catch (const DataError& e) {
    EXPECT_NE(std::string(e.what()).find("white, band_limited, prbs"), std::string::npos);
  }
}

TEST(BaselineSignals, InputsAreIndependent) {
  // Otherwise [A B] could not be told apart. A single line has two degrees of freedom: two inputs.
  for (const BaselineKind kind : allBaselines()) {
    SCOPED_TRACE(toString(kind));
    const int inputs = kind == BaselineKind::kLine ? 2 : 3;
    const Eigen::MatrixXd U = baselineSignal(specOf(kind, inputs));
    const Eigen::MatrixXd gram = U * U.transpose() / 2006.7;
    // Orthogonal inputs would have 1/n_u of the energy each, at least 1/3.
    EXPECT_GT(quad_support::symmetricEigenvalues(gram)(0), 0.2);
  }
}

TEST(BaselineSignals, WhiteNoiseIsTheGaussianSignal) {
  EXPECT_LT(
      (baselineSignal(specOf(BaselineKind::kWhite)) - gaussianSignal(2006.7, 1, 370, 11, 0, 3))
          .norm(),
      1e-12);
}

TEST(BaselineSignals, BandLimitedNoiseStaysInItsBand) {
  BaselineSpec spec = specOf(BaselineKind::kBandLimited);
  spec.band_low = 5.0 / 370;
  spec.band_high = 20.0 / 370;
  const Eigen::MatrixXd u = baselineSignal(spec);
  std::set<int> band;
  for (int h = 5; h <= 20; ++h) band.insert(h);
  EXPECT_LT(strayEnergy(u, band), kNoise);
  std::set<int> narrower = band;
  narrower.erase(20);
  EXPECT_GT(strayEnergy(u, narrower), 1e-6);  // the end belongs to it
  spec.band_low = 0.5001 / 370;
  spec.band_high = 0.9 / 370;
  EXPECT_NE(messageOf(spec).find("holds no harmonic"), std::string::npos);
}

TEST(BaselineSignals, MaximumLengthSequencesAreOfMaximumLength) {
  for (int order = 2; order <= 24; ++order) {
    SCOPED_TRACE(order);
    const int period = (1 << order) - 1, length = period + 100;
    const std::vector<int> bits = maximumLengthSequence(order, 1, length);
    int sum = 0;
    std::vector<bool> seen(static_cast<std::size_t>(period) + 1);
    int window = 0, different = 0;
    for (int k = 0; k < length; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (k >= period) {
        EXPECT_EQ(bits[i], bits[i - static_cast<std::size_t>(period)]);
      }
      if (k < period) sum += bits[i];
      window = ((window << 1) | (bits[i] > 0)) & period;
      if (k < order - 1 || seen[static_cast<std::size_t>(window)]) continue;
      seen[static_cast<std::size_t>(window)] = true;
      ++different;
    }
    EXPECT_EQ(sum, 1);             // one more of one level than of the other
    EXPECT_EQ(different, period);  // every content of the register but zero: the longest period
  }
}

TEST(BaselineSignals, PrbsHasTwoLevelsAndAFlatAutocorrelation) {
  BaselineSpec spec = specOf(BaselineKind::kPrbs, 1, 2 * 127);
  spec.lines = {};
  spec.order = 7;
  spec.energy = 254.0;  // levels ±1
  const Eigen::RowVectorXd u = baselineSignal(spec);
  for (int k = 0; k < 254; ++k) EXPECT_NEAR(std::abs(u(k)), 1.0, 1e-14);
  for (int lag = 1; lag < 127; ++lag) {
    EXPECT_NEAR(u.segment(0, 127).dot(u.segment(lag, 127)), -1.0, 1e-11);
  }
  EXPECT_EQ(u.head(127), u.tail(127));
  spec.hold = 4;
  const Eigen::RowVectorXd slow = baselineSignal(spec);
  for (int k = 0; k < 252; ++k) EXPECT_EQ(slow(k), slow(k - k % 4));
}

TEST(BaselineSignals, ChirpSweepsTheBand) {
  BaselineSpec spec = specOf(BaselineKind::kChirp, 1, 4000);
  spec.lines = {};
  spec.band_low = 0.01;
  spec.band_high = 0.11;
  const Eigen::RowVectorXd u = baselineSignal(spec);
  const auto crossings = [&](int first, int last) {
    int count = 0;
    for (int k = first + 1; k < last; ++k) count += u(k - 1) < 0.0 && u(k) >= 0.0;
    return count;
  };
  // Turns in a stretch are the mean frequency times its length; the ends cost at most one.
  EXPECT_NEAR(crossings(0, 400), 400 * 0.015, 1);
  EXPECT_NEAR(crossings(1800, 2200), 400 * 0.06, 1);
  EXPECT_NEAR(crossings(3600, 4000), 400 * 0.105, 1);
}

TEST(BaselineSignals, MultisinesAreFlatOnTheirLinesAndNowhereElse) {
  for (const BaselineKind kind : {BaselineKind::kMultisine, BaselineKind::kRandomPhase}) {
    const Eigen::RowVectorXd u = baselineSignal(specOf(kind));
    EXPECT_LT(strayEnergy(u, {3, 6, 8, 10}), kNoise);
    for (const int h : {3, 6, 8, 10}) {
      EXPECT_NEAR(std::abs(dft(u, h)), std::sqrt(2006.7 * 370 / 8), 1e-9);  // a quarter each
    }
    // Without lines: every harmonic of the band, here by the fast transform.
    BaselineSpec band = specOf(kind);
    band.lines = {};
    band.band_high = 30.5 / 370;
    const Eigen::RowVectorXd wide = baselineSignal(band);
    for (int h = 1; h <= 30; ++h)
      EXPECT_NEAR(std::abs(dft(wide, h)), std::sqrt(2006.7 * 370 / 60), 1e-9);
    EXPECT_NEAR(std::abs(dft(wide, 31)), 0.0, 1e-9);
  }
}

TEST(BaselineSignals, SchroederPhasesKeepThePeakSmall) {
  BaselineSpec spec = specOf(BaselineKind::kMultisine, 1, 1024);
  spec.lines = {};
  spec.band_high = 100.0 / 1024;
  const Eigen::RowVectorXd u = baselineSignal(spec);
  const double rms = std::sqrt(u.squaredNorm() / 1024);
  EXPECT_LT(u.cwiseAbs().maxCoeff() / rms, 1.9);  // equal phases: sqrt(200) = 14
}

TEST(BaselineSignals, MultisineOfSeveralInputsSharesTheLines) {
  const Eigen::MatrixXd U = baselineSignal(specOf(BaselineKind::kMultisine, 2));
  EXPECT_LT(strayEnergy(U.row(0), {3, 8}), kNoise);
  EXPECT_LT(strayEnergy(U.row(1), {6, 10}), kNoise);
  EXPECT_NE(messageOf(specOf(BaselineKind::kMultisine, 5)), "");
}

TEST(BaselineSignals, SingleLineHasTheAskedPhase) {
  BaselineSpec spec = specOf(BaselineKind::kLine);
  spec.lines = {370, {10}, {}};
  const double amplitude = std::sqrt(2.0 * 2006.7 / 370);
  for (const Phase phase : {Phase::kSin, Phase::kCos}) {
    spec.line_phase = phase;
    const Eigen::MatrixXd expected =
        multisine(spec.lines, phase, Eigen::MatrixXd::Constant(1, 1, amplitude));
    EXPECT_LT((baselineSignal(spec) - expected).norm(), 1e-11);
  }
  spec.lines = {};
  EXPECT_NE(messageOf(spec), "");
}

TEST(BaselineSignals, RefusesWhatMakesNoSense) {
  const auto with = [](auto change) {
    BaselineSpec spec = specOf(BaselineKind::kWhite);
    change(spec);
    return messageOf(spec);
  };
  EXPECT_EQ(with([](BaselineSpec&) {}), "");
  EXPECT_EQ(with([](BaselineSpec& s) { s.energy = -1; }),
            "energy = -1; must be a finite number, 0 or above");
  EXPECT_NE(with([](BaselineSpec& s) { s.energy = NAN; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.num_samples = 0; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.num_inputs = 0; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.band_high = 0.6; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.band_low = 0.5; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.hold = 0; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.order = 25; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.lines.num_samples = 371; }), "");
  EXPECT_NE(with([](BaselineSpec& s) { s.lines.harmonics = {185}; }), "");
}

TEST(BaselineSignals, AmplitudesOfSumsOfLinesMakeTheSignal) {
  for (const bool grid : {true, false}) {
    for (const BaselineKind kind : allBaselines()) {
      SCOPED_TRACE(toString(kind));
      BaselineSpec spec;
      spec.kind = kind;
      spec.num_samples = 90;
      spec.num_inputs = 2;
      spec.energy = 7.0;
      spec.lines = {90, {}, {0.004, 0.013, 0.21}};
      if (grid) spec.lines = {90, {2, 5, 31}, {}};
      const bool of_lines = kind == BaselineKind::kMultisine ||
                            kind == BaselineKind::kRandomPhase || kind == BaselineKind::kLine;
      const Eigen::MatrixXd a = baselineAmplitudes(spec), U = baselineSignal(spec);
      ASSERT_EQ(a.size() > 0, of_lines);
      if (!of_lines) continue;
      SpectralLines lines = spec.lines;
      if (kind == BaselineKind::kLine) {
        lines.harmonics.resize(grid ? 1 : 0);
        lines.frequencies.resize(grid ? 0 : 1);
      }
      EXPECT_LT((multisine(lines, Phase::kBoth, a) - U).norm(), 1e-13 * U.norm());
      // On the grid Σ‖u_k‖² = (T/2)‖a‖².
      if (grid) {
        EXPECT_NEAR(45.0 * a.squaredNorm(), 7.0, 1e-12);
      }
    }
  }
}
