/// The vertical motion of a multirotor, thesis sections 2.3 and 2.4.1: the only file that knows the
/// application.
#pragma once

#include <vector>

#include "explore_opt/linear_system.hpp"

namespace explore_opt {

/// ẋ = [[0, 1], [0, 0]] x + [0; 1/m] U + [0; -g], Eq. (2.1), x = [z; ż], U the thrust [N], sampled
/// with U held for dT: the closed form of Eq. (2.2). No value is rounded.
/// @param mass  m [kg]   @param sampling_period  dT > 0 [s]   @param gravity  g [m/s²]
LinearSystem altitudeModel(double mass, double sampling_period, double gravity);

/// f_c = 1 / (2π m) [Hz]: where the gain from thrust to ż crosses 0 dB. The thesis calls it a
/// cut-off frequency, but an integrator has none; thesis section 2.4.1 prints 0.218 Hz for m = 0.73
/// kg.
double crossoverFrequency(double mass);

/// Lines of the exploration signal, all on the grid of whole multiples of 1/T.
struct FrequencyGrid {
  double crossover = 0.0;           ///< f_c [Hz]
  double exact_time = 0.0;          ///< 8 / f_c [s], before rounding
  double exploration_time = 0.0;    ///< T_exp [s], rounded
  int num_samples = 0;              ///< T
  std::vector<int> harmonics;       ///< {3, 6, 8, 10}: multiples of 1/T
  std::vector<double> frequencies;  ///< harmonics / (T dT) [Hz]
};

/// {3, 6, 8, 10}/8 f_c moved onto the grid: the period 8/f_c of the slowest common line, rounded to
/// whole `time_unit`s, and T = T_exp / dT rounded to a whole number, thesis section 2.4.1 (36.69 s
/// -> 37 s -> 370). Give the mass and dT of the model the choice is based on: the truth (as the
/// thesis does) or the estimate.
/// @throws quad_support::DataError if a value is out of range, or T is too short for ten lines
/// below T/2
FrequencyGrid crossoverGrid(double mass, double sampling_period, double time_unit = 1.0);

}  // namespace explore_opt
