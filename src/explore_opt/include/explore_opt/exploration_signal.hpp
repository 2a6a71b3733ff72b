/// Exploration inputs: sums of carriers, Eq. (1.14), and random signals of the same energy, Eq.
/// (3.3).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace explore_opt {

/// Which carriers an amplitude multiplies. One setting for design and signal: the text of the
/// thesis has a cosine in (1.14), a sine in section 2.4.2, and its numbers fit the sine.
enum class Phase { kSin, kCos, kBoth };

std::string toString(Phase phase);  ///< "sin", "cos", "both"
/// @throws quad_support::DataError naming the choices
Phase phaseFromString(const std::string& text);

/// The lines of a signal of T samples, as whole multiples of 1/T or as frequencies; one of the two
/// lists is empty.
struct SpectralLines {
  int num_samples = 0;              ///< T
  std::vector<int> harmonics;       ///< h_i: f_i = h_i / T exactly
  std::vector<double> frequencies;  ///< f_i [cycles per sample]

  int size() const {
    return static_cast<int>(harmonics.empty() ? frequencies.size() : harmonics.size());
  }
};

/// Both lists or neither given, T < 1, a line outside (0, 1/2) (at 0 and 1/2 a sine is identically
/// zero and a cosine has twice the energy), or a line given twice: @throws quad_support::DataError
/// naming line, value and range.
void validate(const SpectralLines& lines);

/// Number of carriers: lines, or twice as many with both phases.
int numCarriers(const SpectralLines& lines, Phase phase);

/// cos and sin of 2π f_i k; of a harmonic from the whole number h k mod T.
struct CarrierValue {
  double cosine, sine;
};
CarrierValue carrierAt(const SpectralLines& lines, int line, int k);

/// The carriers at k = 0 ... T-1, numCarriers x T: s(2π f_i k), with both phases first all cosines,
/// then all sines. The phase of a harmonic is taken from the whole number h k mod T, so it is as
/// exact at the end as at the start.
Eigen::MatrixXd carriers(const SpectralLines& lines, Phase phase);

/// u_k = Σ_i α_i s(2π f_i k), Eq. (1.14).
/// @param amplitudes  numCarriers x n_u   @returns n_u x T   @throws quad_support::DataError for
/// wrong shapes
Eigen::MatrixXd multisine(const SpectralLines& lines, Phase phase,
                          const Eigen::MatrixXd& amplitudes);

/// Σ_k ‖u_k‖², Eq. (3.2).
double signalEnergy(const Eigen::MatrixXd& U);

/// Normally distributed samples scaled to Σ_k ‖u_k‖² = energy, Eq. (3.3).
/// @param seed, run, stream  address of the random numbers; the step is k, the draw the input
/// @returns n_u x T   @throws quad_support::DataError if energy < 0 or a size is below 1
Eigen::MatrixXd gaussianSignal(double energy, int num_inputs, int num_samples, std::uint64_t seed,
                               std::uint64_t run, std::uint64_t stream);

}  // namespace explore_opt
