#include "explore_opt/baseline_signals.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "checks.hpp"
#include "constants.hpp"
#include "quad_support/random_stream.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;

struct NamedKind {
  BaselineKind kind;
  const char* name;
};
constexpr std::array<NamedKind, 7> kNames = {{{BaselineKind::kWhite, "white"},
                                              {BaselineKind::kBandLimited, "band_limited"},
                                              {BaselineKind::kPrbs, "prbs"},
                                              {BaselineKind::kChirp, "chirp"},
                                              {BaselineKind::kMultisine, "multisine"},
                                              {BaselineKind::kRandomPhase, "random_phase"},
                                              {BaselineKind::kLine, "line"}}};

/// Feedback taps of primitive polynomials: bit n of a mask stands for x^n.
std::uint32_t feedbackMask(int order) {
  static const std::array<std::vector<int>, 25> kTaps = {{{},
                                                          {},
                                                          {2, 1},
                                                          {3, 2},
                                                          {4, 3},
                                                          {5, 3},
                                                          {6, 5},
                                                          {7, 6},
                                                          {8, 6, 5, 4},
                                                          {9, 5},
                                                          {10, 7},
                                                          {11, 9},
                                                          {12, 11, 10, 4},
                                                          {13, 12, 11, 8},
                                                          {14, 13, 12, 2},
                                                          {15, 14},
                                                          {16, 15, 13, 4},
                                                          {17, 14},
                                                          {18, 11},
                                                          {19, 18, 17, 14},
                                                          {20, 17},
                                                          {21, 19},
                                                          {22, 21},
                                                          {23, 18},
                                                          {24, 23, 22, 17}}};
  std::uint32_t mask = 0;
  for (const int tap : kTaps[static_cast<std::size_t>(order)]) mask |= 1u << (tap - 1);
  return mask;
}

int parity(std::uint32_t bits) {
  int odd = 0;
  for (; bits != 0; bits &= bits - 1) odd ^= 1;
  return odd;
}

void validate(const BaselineSpec& s) {
  require(s.num_samples >= 1, "T = {}; must be at least 1", s.num_samples);
  require(s.num_inputs >= 1, "inputs = {}; must be at least 1", s.num_inputs);
  require(std::isfinite(s.energy) && s.energy >= 0.0,
          "energy = {}; must be a finite number, 0 or above", s.energy);
  require(s.band_low >= 0.0 && s.band_low < s.band_high && s.band_high <= 0.5,
          "band = {} to {}; must be 0 <= low < high <= 1/2 cycles per sample", s.band_low,
          s.band_high);
  require(s.hold >= 1, "hold = {}; must be at least 1 sample", s.hold);
  require(s.order == 0 || (s.order >= 2 && s.order <= 24), "order = {}; must be 0 or 2 to 24",
          s.order);
  require(s.line_phase != Phase::kBoth, "phase of a single line is both; must be sin or cos");
  if (s.lines.size() == 0) return;
  require(s.lines.num_samples == s.num_samples, "lines are for T = {}, the signal has T = {}",
          s.lines.num_samples, s.num_samples);
  explore_opt::validate(s.lines);
}

/// Harmonics h with low <= h/T <= high, without the constant and the one at 1/2.
std::vector<int> harmonicsOf(const BaselineSpec& s) {
  std::vector<int> harmonics;
  const double T = s.num_samples;
  for (int h = 1; 2 * h < s.num_samples; ++h) {
    if (h >= s.band_low * T && h <= s.band_high * T) harmonics.push_back(h);
  }
  require(!harmonics.empty(), "band = {} to {} holds no harmonic of T = {} below 1/2", s.band_low,
          s.band_high, s.num_samples);
  return harmonics;
}

/// Σ_h Re(c_h e^{2πj h k/T}), k = 0 ... T-1.
RowVectorXd fromHarmonics(const std::vector<int>& harmonics,
                          const std::vector<std::complex<double>>& coefficients, int T) {
  std::vector<std::complex<double>> spectrum(static_cast<std::size_t>(T)), time;
  for (std::size_t i = 0; i < harmonics.size(); ++i)
    spectrum[static_cast<std::size_t>(harmonics[i])] = coefficients[i];
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::Unscaled);
  fft.inv(time, spectrum);
  RowVectorXd u(T);
  for (int k = 0; k < T; ++k) u(k) = time[static_cast<std::size_t>(k)].real();
  return u;
}

/// The same for given lines, on the grid or off it.
RowVectorXd fromLines(const SpectralLines& lines,
                      const std::vector<std::complex<double>>& coefficients) {
  const auto L = static_cast<Eigen::Index>(coefficients.size());
  Eigen::VectorXd amplitudes(2 * L);  // Re(c e^{jx}) = Re c cos x - Im c sin x
  for (Eigen::Index i = 0; i < L; ++i) {
    amplitudes(i) = coefficients[static_cast<std::size_t>(i)].real();
    amplitudes(L + i) = -coefficients[static_cast<std::size_t>(i)].imag();
  }
  return multisine(lines, Phase::kBoth, amplitudes);
}

/// Sums of lines, c(input, index of the line, number of lines) being a line's complex amplitude.
template <class Coefficient>
MatrixXd sumOfLines(const BaselineSpec& s, bool lines_given, const Coefficient& c) {
  const std::vector<int> harmonics = lines_given ? std::vector<int>{} : harmonicsOf(s);
  const int L = lines_given ? s.lines.size() : static_cast<int>(harmonics.size());
  MatrixXd U(s.num_inputs, s.num_samples);
  for (int j = 0; j < s.num_inputs; ++j) {
    std::vector<std::complex<double>> coefficients;
    for (int i = 0; i < L; ++i) coefficients.push_back(c(j, i, L));
    U.row(j) = lines_given ? fromLines(s.lines, coefficients)
                           : fromHarmonics(harmonics, coefficients, s.num_samples);
  }
  return U;
}

MatrixXd bandLimited(const BaselineSpec& s) {
  const quad_support::RandomStream random(s.seed, s.run, s.stream);
  return sumOfLines(s, false, [&](int j, int i, int) {
    const auto step = static_cast<std::uint64_t>(i), draw = static_cast<std::uint64_t>(2 * j);
    return std::complex<double>(random.normal(step, draw), random.normal(step, draw + 1));
  });
}

/// Phases -π i(i+1)/L keep the peak of equal lines near 1.7 times the r.m.s. value (Schroeder
/// 1970). Line i goes to input i mod n_u, so that no two inputs share a line.
MatrixXd flatMultisine(const BaselineSpec& s) {
  const bool given = s.lines.size() > 0;
  const int L = given ? s.lines.size() : static_cast<int>(harmonicsOf(s).size());
  require(L >= s.num_inputs, "{} lines for {} inputs; a flat multisine needs one for each", L,
          s.num_inputs);
  return sumOfLines(s, given, [&](int j, int i, int count) {
    const double turns = std::fmod(0.5 * i * (i + 1.0) / count, 1.0);
    return i % s.num_inputs == j ? std::polar(1.0, -2.0 * kPi * turns) : std::complex<double>();
  });
}

MatrixXd randomPhase(const BaselineSpec& s) {
  const quad_support::RandomStream random(s.seed, s.run, s.stream);
  return sumOfLines(s, s.lines.size() > 0, [&](int j, int i, int) {
    return std::polar(
        1.0,
        2.0 * kPi * random.uniform(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)));
  });
}

MatrixXd singleLine(const BaselineSpec& s) {
  require(s.lines.size() >= 1, "a single line needs a harmonic or a frequency");
  SpectralLines line{s.num_samples, {}, {}};
  if (s.lines.harmonics.empty()) line.frequencies = {s.lines.frequencies.front()};
  if (!s.lines.harmonics.empty()) line.harmonics = {s.lines.harmonics.front()};
  MatrixXd U(s.num_inputs, s.num_samples);
  for (int j = 0; j < s.num_inputs; ++j) {
    const double quarter = s.line_phase == Phase::kSin ? -0.5 * kPi : 0.0;
    U.row(j) = fromLines(line, {std::polar(1.0, quarter + kPi * j / s.num_inputs)});
  }
  return U;
}

MatrixXd chirp(const BaselineSpec& s) {
  const int T = s.num_samples;
  RowVectorXd u(T);
  for (int k = 0; k < T; ++k) {
    // The instantaneous frequency at sample k is low + (high - low) k/T.
    const double turns = s.band_low * k + 0.5 * (s.band_high - s.band_low) * k * (double(k) / T);
    u(k) = std::sin(2.0 * kPi * (turns - std::floor(turns)));
  }
  MatrixXd U(s.num_inputs, T);
  for (int j = 0; j < s.num_inputs; ++j) {
    const auto shift = static_cast<int>(std::int64_t{j} * T / s.num_inputs);
    for (int k = 0; k < T; ++k) U(j, k) = u((k + shift) % T);
  }
  return U;
}

MatrixXd prbs(const BaselineSpec& s) {
  const std::int64_t bits = (std::int64_t{s.num_samples} + s.hold - 1) / s.hold;
  int order = s.order == 0 ? 2 : s.order;
  while (s.order == 0 && (std::int64_t{1} << order) - 1 < bits) ++order;
  require(order <= 24, "T = {}; a binary sequence that does not repeat is known up to {} samples",
          s.num_samples, (1 << 24) - 1);
  const int period = (1 << order) - 1;
  const quad_support::RandomStream random(s.seed, s.run, s.stream);
  const auto start = 1 + static_cast<std::uint32_t>(random.uniform(0) * period);
  const std::vector<int> sequence = maximumLengthSequence(order, start, period);
  MatrixXd U(s.num_inputs, s.num_samples);
  for (int j = 0; j < s.num_inputs; ++j) {
    const std::int64_t shift = std::int64_t{j} * period / s.num_inputs;
    for (int k = 0; k < s.num_samples; ++k)
      U(j, k) = sequence[static_cast<std::size_t>((k / s.hold + shift) % period)];
  }
  return U;
}

MatrixXd unscaled(const BaselineSpec& s) {
  switch (s.kind) {
    case BaselineKind::kWhite:
      return gaussianSignal(1.0, s.num_inputs, s.num_samples, s.seed, s.run, s.stream);
    case BaselineKind::kBandLimited:
      return bandLimited(s);
    case BaselineKind::kPrbs:
      return prbs(s);
    case BaselineKind::kChirp:
      return chirp(s);
    case BaselineKind::kMultisine:
      return flatMultisine(s);
    case BaselineKind::kRandomPhase:
      return randomPhase(s);
    case BaselineKind::kLine:
      return singleLine(s);
  }
  throw quad_support::DataError("no such kind of signal");
}

}  // namespace

std::string toString(BaselineKind kind) {
  for (const NamedKind& named : kNames) {
    if (named.kind == kind) return named.name;
  }
  return "";
}

BaselineKind baselineFromString(const std::string& text) {
  std::string choices;
  for (const NamedKind& named : kNames) {
    if (text == named.name) return named.kind;
    choices += std::string(choices.empty() ? "" : ", ") + named.name;
  }
  throw quad_support::DataError(fmt::format("signal = '{}'; must be one of {}", text, choices));
}

std::vector<BaselineKind> allBaselines() {
  std::vector<BaselineKind> kinds;
  for (const NamedKind& named : kNames) kinds.push_back(named.kind);
  return kinds;
}

bool isRandom(BaselineKind kind) {
  return kind == BaselineKind::kWhite || kind == BaselineKind::kBandLimited ||
         kind == BaselineKind::kPrbs || kind == BaselineKind::kRandomPhase;
}

Eigen::MatrixXd baselineSignal(const BaselineSpec& spec) {
  validate(spec);
  const MatrixXd U = unscaled(spec);
  const double energy = signalEnergy(U);
  require(energy > 0.0, "{} with T = {} is zero throughout; more samples are needed",
          toString(spec.kind), spec.num_samples);
  return U * std::sqrt(spec.energy / energy);
}

std::vector<int> maximumLengthSequence(int order, std::uint32_t start, int length) {
  require(order >= 2 && order <= 24, "order = {}; must be 2 to 24", order);
  require(start >= 1 && start < (1u << order), "start = {}; must be 1 to {}", start,
          (1u << order) - 1);
  require(length >= 0, "length = {}; must be 0 or above", length);
  const std::uint32_t mask = feedbackMask(order), all = (1u << order) - 1;
  std::vector<int> bits(static_cast<std::size_t>(length));
  std::uint32_t state = start;
  for (int& bit : bits) {
    bit = (state >> (order - 1)) & 1 ? 1 : -1;
    state = ((state << 1) | static_cast<std::uint32_t>(parity(state & mask))) & all;
  }
  return bits;
}

}  // namespace explore_opt
