#include "explore_opt/exploration_signal.hpp"

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "constants.hpp"
#include "quad_support/random_stream.hpp"

namespace explore_opt {
namespace {

/// A point of the unit circle given as a fraction of a turn, folded to within an eighth of one of
/// the axes, so that sines and cosines of equal angles come out equal and those of multiples of a
/// quarter turn exact.
using Turn = CarrierValue;

Turn turn(double fraction) {
  const double quarters = std::round(4.0 * fraction);
  const double angle = kTwoPi * (fraction - 0.25 * quarters);
  const double c = std::cos(angle), s = std::sin(angle);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Turn turnOfHarmonic(std::int64_t harmonic, std::int64_t k, std::int64_t T) {
  const std::int64_t rest = harmonic * k % T;
  const std::int64_t nearest =
      2 * rest > T ? rest - T : rest;  // within half a turn: sines come out exactly odd
  return turn(static_cast<double>(nearest) / static_cast<double>(T));
}

Turn turnOfFrequency(double frequency, double k) {
  const double product = frequency * k;
  const double lost = std::fma(frequency, k, -product);
  return turn(product - std::floor(product) + lost);
}

template <typename T>
void requireDistinct(const std::vector<T>& values, const char* name) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto first = std::find(values.begin(), values.end(), values[i]);
    require(first == values.begin() + static_cast<std::ptrdiff_t>(i),
            "{}[{}] = {} stands in the list already (at {})", name, i, values[i],
            first - values.begin());
  }
}

/// Two frequencies that T samples cannot tell apart are one line, whose amplitude would be shared
/// out between both at a lower norm.
void requireApart(const std::vector<double>& frequencies, int T) {
  constexpr double kSameTurns = 1e-6;  // over all samples
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      require(std::abs(frequencies[i] - frequencies[j]) * T > kSameTurns,
              "frequencies[{}] = {} and frequencies[{}] = {} are the same within T = {} samples; "
              "leave one out",
              j, frequencies[j], i, frequencies[i], T);
    }
  }
}

/// Lines f and 1 - f (h and T - h) are the same.
template <typename T>
void requireNotMirrored(const std::vector<T>& values, T whole, const char* name) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(2 * values[i] > whole)) continue;
    for (const T other : values) {
      require(other != whole - values[i],
              "{0}[{1}] = {2}, but {2} is {3} mirrored, the same line; leave it out", name, i,
              values[i], other);
    }
  }
}

}  // namespace

std::string toString(Phase phase) {
  return phase == Phase::kSin ? "sin" : phase == Phase::kCos ? "cos" : "both";
}

Phase phaseFromString(const std::string& text) {
  for (const Phase phase : {Phase::kSin, Phase::kCos, Phase::kBoth}) {
    if (text == toString(phase)) return phase;
  }
  throw quad_support::DataError(fmt::format("phase = '{}'; must be sin, cos or both", text));
}

void validate(const SpectralLines& lines) {
  const int T = lines.num_samples;
  require(T >= 1, "T = {}; must be at least 1", T);
  require(lines.harmonics.empty() != lines.frequencies.empty(),
          "{} harmonics and {} frequencies; give exactly one of the two lists",
          lines.harmonics.size(), lines.frequencies.size());
  require(lines.harmonics.empty() || T >= 3,
          "T = {} samples hold no harmonic below T/2; T must be at least 3", T);
  requireNotMirrored(lines.harmonics, T, "harmonics");
  requireNotMirrored(lines.frequencies, 1.0, "frequencies");
  for (std::size_t i = 0; i < lines.harmonics.size(); ++i) {
    const int h = lines.harmonics[i];
    require(h > 0 && h <= (T - 1) / 2, "harmonics[{}] = {}; must lie in 1..{} (below T/2, T = {})",
            i, h, (T - 1) / 2, T);
  }
  for (std::size_t i = 0; i < lines.frequencies.size(); ++i) {
    const double f = lines.frequencies[i];
    require(f > 0.0 && f < 0.5,
            "frequencies[{}] = {}; must lie between 0 and 1/2 cycles per sample, ends excluded", i,
            f);
  }
  requireDistinct(lines.harmonics, "harmonics");
  requireDistinct(lines.frequencies, "frequencies");
  requireApart(lines.frequencies, T);
}

CarrierValue carrierAt(const SpectralLines& lines, int line, int k) {
  const auto i = static_cast<std::size_t>(line);
  return lines.harmonics.empty() ? turnOfFrequency(lines.frequencies[i], k)
                                 : turnOfHarmonic(lines.harmonics[i], k, lines.num_samples);
}

int numCarriers(const SpectralLines& lines, Phase phase) {
  return phase == Phase::kBoth ? 2 * lines.size() : lines.size();
}

Eigen::MatrixXd carriers(const SpectralLines& lines, Phase phase) {
  validate(lines);
  const int L = lines.size(), T = lines.num_samples;
  Eigen::MatrixXd rows(numCarriers(lines, phase), T);
  for (int k = 0; k < T; ++k) {
    for (int i = 0; i < L; ++i) {
      const Turn t = carrierAt(lines, i, k);
      rows(i, k) = phase == Phase::kSin ? t.sine : t.cosine;
      if (phase == Phase::kBoth) rows(L + i, k) = t.sine;
    }
  }
  return rows;
}

Eigen::MatrixXd multisine(const SpectralLines& lines, Phase phase,
                          const Eigen::MatrixXd& amplitudes) {
  validate(lines);
  require(amplitudes.rows() == numCarriers(lines, phase) && amplitudes.cols() >= 1,
          "amplitudes are {} x {}; must have {} rows, one a carrier, and a column an input",
          amplitudes.rows(), amplitudes.cols(), numCarriers(lines, phase));
  requireFinite(amplitudes, "amplitudes");
  return amplitudes.transpose() * carriers(lines, phase);
}

double signalEnergy(const Eigen::MatrixXd& U) { return U.squaredNorm(); }

Eigen::MatrixXd gaussianSignal(double energy, int num_inputs, int num_samples, std::uint64_t seed,
                               std::uint64_t run, std::uint64_t stream) {
  require(std::isfinite(energy) && energy >= 0.0,
          "energy = {}; must be a finite number, 0 or above", energy);
  require(num_inputs >= 1 && num_samples >= 1, "{} inputs, {} samples; both must be at least 1",
          num_inputs, num_samples);
  const quad_support::RandomStream random(seed, run, stream);
  Eigen::MatrixXd U(num_inputs, num_samples);
  for (int k = 0; k < num_samples; ++k) {
    for (int j = 0; j < num_inputs; ++j) {
      U(j, k) = random.normal(static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(j));
    }
  }
  return U * std::sqrt(energy / signalEnergy(U));  // Eq. (3.3)
}

}  // namespace explore_opt
