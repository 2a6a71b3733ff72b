/// What other signals must cost to meet the condition a design meets.
#pragma once

#include <string>
#include <vector>

#include "explore_opt/exploration_design.hpp"

namespace explore_opt {

struct BaselineOptions {
  int seeds = 20;          ///< of each random signal
  std::uint64_t seed = 1;  ///< the first of them, and of the designs
  double band_low = 0.0,
         band_high =
             0.0;  ///< [cycles per sample]; both 0: from the problem's lowest to its highest line
};

/// A signal scaled so that the noise-free response of the nominal system meets the condition at the
/// least cost (away from rest: the cheaper of the signal and its negative).
///
/// Cost is γ_e of the design. With cost on the input: sqrt(2 Σ‖u_k‖²/T), u_k = K x_k + e_k. With
/// cost on the signal: ‖a‖ of signals made of the problem's lines, sqrt(2 Σ‖e_k‖²/T) of others,
/// which on the grid is the same number. Off the grid it is not: lines there may cost less, or
/// more, by ‖a‖ than by their energy, so others are comparable with each other but not with γ_e.
/// Peak limits (ExplorationProblem::u_max) are not imposed.
struct BaselineCost {
  std::string name;
  std::string note;   ///< what was chosen: band, line, hold
  int seeds = 1;      ///< tried
  int failed = 0;     ///< of them excite too little at any size; their cost is infinite
  double cost = 0.0;  ///< median over the seeds
  double least = 0.0, largest = 0.0;
  double peak = 0.0;  ///< max_k ‖e_k‖ of the median's signal; infinite if the cost is
};

/// The targeted design first ("targeted"), then the classical designs and the signals of
/// baseline_signals.hpp: white, band_limited, prbs (its best hold), chirp, multisine and
/// random_phase on the problem's lines, and the cheapest single line.
/// Several experiments: random signals are drawn anew in each, the others repeated; cost is then
/// the root mean square per experiment.
/// @param amplitudes  of the targeted design, carriers x n_u, experiments one below the other
/// @throws quad_support::DataError for a problem or an option out of range
std::vector<BaselineCost> compareBaselines(const ExplorationProblem& problem,
                                           const Eigen::MatrixXd& amplitudes,
                                           const BaselineOptions& options = {});

}  // namespace explore_opt
