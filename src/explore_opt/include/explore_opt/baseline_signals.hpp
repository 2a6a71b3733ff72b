/// Excitations a targeted design is compared with: the ones in every textbook, all seeded, all of a
/// given energy.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "explore_opt/exploration_signal.hpp"

namespace explore_opt {

enum class BaselineKind {
  /// Independent normal samples
  kWhite,
  /// Normal Fourier coefficients on the harmonics of the band, none outside
  kBandLimited,
  /// Maximum-length binary sequence: two levels ±c; inputs are shifted copies
  kPrbs,
  /// Sine swept linearly from the band's low to its high end; inputs are circularly shifted copies
  kChirp,
  /// Lines of equal amplitude with Schroeder's phases (small peak); inputs share them out in turn
  kMultisine,
  /// Lines of equal amplitude, phases uniform and independent for each line and input
  kRandomPhase,
  /// One line; inputs are π/n_u apart in phase
  kLine,
};

/// "white", "band_limited", "prbs", "chirp", "multisine", "random_phase", "line"
std::string toString(BaselineKind kind);
/// @throws quad_support::DataError naming the choices
BaselineKind baselineFromString(const std::string& text);
std::vector<BaselineKind> allBaselines();
bool isRandom(BaselineKind kind);  ///< whether another seed gives another signal of another shape

struct BaselineSpec {
  BaselineKind kind = BaselineKind::kWhite;
  int num_samples = 0;                     ///< T >= 1
  int num_inputs = 1;                      ///< n_u >= 1
  double energy = 0.0;                     ///< Σ_k ‖u_k‖², >= 0
  double band_low = 0.0, band_high = 0.5;  ///< [cycles per sample], of band_limited and chirp
  /// Of multisine and random_phase (none: every harmonic of the band) and of line (the first).
  SpectralLines lines;
  Phase line_phase = Phase::kCos;  ///< of line: sin or cos of the first input
  int hold = 1;                    ///< prbs: samples a level lasts
  int order = 0;  ///< prbs: bits n, period (2^n - 1) hold; 0: the shortest that fills T samples
  std::uint64_t seed = 1, run = 0, stream = 0;  ///< address of the random numbers
};

/// @returns n_u x T
/// @throws quad_support::DataError naming the field: value, allowed range; a band without harmonics
Eigen::MatrixXd baselineSignal(const BaselineSpec& spec);

/// The amplitudes of a baselineSignal() made of `lines`, 2 L x n_u: all cosines, then all sines.
/// Empty for other signals. Off the grid their norm is not sqrt(2 energy/T).
/// @throws quad_support::DataError as baselineSignal()
Eigen::MatrixXd baselineAmplitudes(const BaselineSpec& spec);

/// `length` bits ±1 of the maximum-length sequence of `order` bits (2 to 24); it repeats after
/// 2^order - 1. @param start  1 ... 2^order - 1, content of the shift register
std::vector<int> maximumLengthSequence(int order, std::uint32_t start, int length);

}  // namespace explore_opt
