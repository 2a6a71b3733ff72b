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

using Eigen::MatrixXcd;
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

/// Feedback taps of primitive polynomials by order: bit n - 1 stands for x^n.
constexpr std::array<std::uint32_t, 25> kFeedback = {
    0,       0,       0x3,     0x6,      0xc,      0x14,     0x30,    0x60,   0xb8,
    0x110,   0x240,   0x500,   0xe08,    0x1c80,   0x3802,   0x6000,  0xd008, 0x12000,
    0x20400, 0x72000, 0x90000, 0x140000, 0x300000, 0x420000, 0xe10000};

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
RowVectorXd fromHarmonics(const std::vector<int>& harmonics, const MatrixXcd& coefficients, int T) {
  std::vector<std::complex<double>> spectrum(static_cast<std::size_t>(T)), time;
  for (std::size_t i = 0; i < harmonics.size(); ++i)
    spectrum[static_cast<std::size_t>(harmonics[i])] =
        coefficients(static_cast<Eigen::Index>(i), 0);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::Unscaled);
  fft.inv(time, spectrum);
  RowVectorXd u(T);
  for (int k = 0; k < T; ++k) u(k) = time[static_cast<std::size_t>(k)].real();
  return u;
}

/// Amplitudes of the cosines, then the sines: Re(c e^{jx}) = Re c cos x - Im c sin x.
MatrixXd carrierAmplitudes(const MatrixXcd& coefficients) {
  MatrixXd amplitudes(2 * coefficients.rows(), coefficients.cols());
  amplitudes << coefficients.real(), -coefficients.imag();
  return amplitudes;
}

MatrixXcd bandLimited(const BaselineSpec& s, int L) {
  const quad_support::RandomStream random(s.seed, s.run, s.stream);
  MatrixXcd c(L, s.num_inputs);
  for (int j = 0; j < s.num_inputs; ++j) {
    for (int i = 0; i < L; ++i) {
      const auto step = static_cast<std::uint64_t>(i), draw = static_cast<std::uint64_t>(2 * j);
      c(i, j) = {random.normal(step, draw), random.normal(step, draw + 1)};
    }
  }
  return c;
}

/// Phases -π i(i+1)/L keep the peak of equal lines near 1.7 times the r.m.s. value (Schroeder
/// 1970). Line i goes to input i mod n_u, so that no two inputs share a line.
MatrixXcd flatMultisine(const BaselineSpec& s, int L) {
  require(L >= s.num_inputs, "{} lines for {} inputs; a flat multisine needs one for each", L,
          s.num_inputs);
  MatrixXcd c = MatrixXcd::Zero(L, s.num_inputs);
  for (int i = 0; i < L; ++i) {
    const double turns = std::fmod(0.5 * i * (i + 1.0) / L, 1.0);
    c(i, i % s.num_inputs) = std::polar(1.0, -2.0 * kPi * turns);
  }
  return c;
}

MatrixXcd randomPhase(const BaselineSpec& s, int L) {
  const quad_support::RandomStream random(s.seed, s.run, s.stream);
  MatrixXcd c(L, s.num_inputs);
  for (int j = 0; j < s.num_inputs; ++j) {
    for (int i = 0; i < L; ++i) {
      c(i, j) = std::polar(
          1.0,
          2.0 * kPi * random.uniform(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)));
    }
  }
  return c;
}

MatrixXcd singleLine(const BaselineSpec& s) {
  MatrixXcd c(1, s.num_inputs);
  for (int j = 0; j < s.num_inputs; ++j) {
    const double quarter = s.line_phase == Phase::kSin ? -0.5 * kPi : 0.0;
    c(0, j) = std::polar(1.0, quarter + kPi * j / s.num_inputs);
  }
  return c;
}

/// Complex amplitudes of a sum of L lines, L x n_u.
MatrixXcd coefficientsOf(const BaselineSpec& s, int L) {
  if (s.kind == BaselineKind::kBandLimited) return bandLimited(s, L);
  if (s.kind == BaselineKind::kMultisine) return flatMultisine(s, L);
  return s.kind == BaselineKind::kRandomPhase ? randomPhase(s, L) : singleLine(s);
}

/// The lines a signal is a sum of: those given to a kind that looks at them.
SpectralLines linesOf(const BaselineSpec& s) {
  if (s.kind == BaselineKind::kMultisine || s.kind == BaselineKind::kRandomPhase) return s.lines;
  if (s.kind != BaselineKind::kLine) return {};
  require(s.lines.size() >= 1, "a single line needs a harmonic or a frequency");
  SpectralLines line{s.num_samples, {}, {}};
  if (s.lines.harmonics.empty()) line.frequencies = {s.lines.frequencies.front()};
  if (!s.lines.harmonics.empty()) line.harmonics = {s.lines.harmonics.front()};
  return line;
}

MatrixXd sumOfLines(const BaselineSpec& s) {
  const SpectralLines lines = linesOf(s);
  const bool given = lines.size() > 0;
  const std::vector<int> harmonics = given ? std::vector<int>{} : harmonicsOf(s);
  const MatrixXcd c = coefficientsOf(s, given ? lines.size() : static_cast<int>(harmonics.size()));
  MatrixXd U(s.num_inputs, s.num_samples);
  for (int j = 0; j < s.num_inputs; ++j) {
    U.row(j) = given ? RowVectorXd(multisine(lines, Phase::kBoth, carrierAmplitudes(c.col(j))))
                     : fromHarmonics(harmonics, c.col(j), s.num_samples);
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
    case BaselineKind::kPrbs:
      return prbs(s);
    case BaselineKind::kChirp:
      return chirp(s);
    case BaselineKind::kBandLimited:
    case BaselineKind::kMultisine:
    case BaselineKind::kRandomPhase:
    case BaselineKind::kLine:
      return sumOfLines(s);
  }
  throw quad_support::DataError("no such kind of signal");
}

/// The factor that gives a signal the energy asked for.
double toEnergy(const BaselineSpec& spec, const MatrixXd& U) {
  const double energy = signalEnergy(U);
  require(energy > 0.0, "{} with T = {} is zero throughout; more samples are needed",
          toString(spec.kind), spec.num_samples);
  return std::sqrt(spec.energy / energy);
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
  return U * toEnergy(spec, U);
}

Eigen::MatrixXd baselineAmplitudes(const BaselineSpec& spec) {
  validate(spec);
  const SpectralLines lines = linesOf(spec);
  if (lines.size() == 0) return {};
  return carrierAmplitudes(coefficientsOf(spec, lines.size())) * toEnergy(spec, unscaled(spec));
}

std::vector<int> maximumLengthSequence(int order, std::uint32_t start, int length) {
  require(order >= 2 && order <= 24, "order = {}; must be 2 to 24", order);
  require(start >= 1 && start < (1u << order), "start = {}; must be 1 to {}", start,
          (1u << order) - 1);
  require(length >= 0, "length = {}; must be 0 or above", length);
  const std::uint32_t mask = kFeedback[static_cast<std::size_t>(order)], all = (1u << order) - 1;
  std::vector<int> bits(static_cast<std::size_t>(length));
  std::uint32_t state = start;
  for (int& bit : bits) {
    bit = (state >> (order - 1)) & 1 ? 1 : -1;
    state = ((state << 1) | static_cast<std::uint32_t>(parity(state & mask))) & all;
  }
  return bits;
}

}  // namespace explore_opt
