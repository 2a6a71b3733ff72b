/// Which lines to give a design: the harmonics at which a sample of input tells most about the
/// parameters that are asked for.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

struct FrequencyOptions {
  int lines = 0;                           ///< how many; 0: n_φ, enough for any D_des
  double band_low = 0.0, band_high = 0.5;  ///< [cycles per sample]
};

struct FrequencyChoice {
  std::vector<int> harmonics;  ///< chosen, ascending
  std::vector<double> shares;  ///< of the power, of each line and the candidates it stands for
  /// The picture: candidates (the grid's harmonics, thinned to about 1000 by equal ratios)
  std::vector<int> grid;
  Eigen::VectorXd power;  ///< spectrum of the best steady-state signal on them, Σ = 1
  Eigen::MatrixXd gain;   ///< |x_i/u_j| of column i n_u + j, rows as grid
  Eigen::MatrixXd phase;  ///< its angle [rad]
};

/// Steady state: with power p_h of independent inputs at harmonic h the information is
/// M(p) = Σ p_h (T/2) Re(V_h V_hᴴ), V_h = [(e^{jω}I - A - BK)⁻¹B; …] (math.md 9), normalised by
/// D_des; with known entries a block of it for each set of regressors unknown in some row of [A B].
/// The spectrum minimises tr M^{-3} (Kiefer's criterion between A- and E-optimality) by
/// multiplicative steps; lines are the peaks of what it uses, each standing for its neighbourhood,
/// and where these are too few the middles of the neighbourhoods with most power beside their line.
/// Transients are not seen: the design that follows takes them into account.
/// The problem's own lines play no part. @throws quad_support::DataError for options out of range;
/// quad_support::NegativeAnswer if A + BK is unstable (there is no steady state: add K), or if no
/// spectrum excites all unknown parameters
FrequencyChoice chooseFrequencies(const ExplorationProblem& problem,
                                  const FrequencyOptions& options = {});

}  // namespace explore_opt
