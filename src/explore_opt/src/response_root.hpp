/// The responses of the nominal system with the time taken out.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// Matrices with Φ_a Φ_bᵀ = blocks[a]ᵀ blocks[b], r x n_φ each, for the responses Φ_a, n_φ x T, to
/// unit amplitude of each component and, if x_0 is not zero, to x_0 alone (the last one).
struct ResponseRoot {
  std::vector<Eigen::MatrixXd> blocks;
};

/// Doubles the horizon by R_2t = triangle of [R_t; R_t (Fᵗ)ᵀ], F the generator of states and
/// carriers: O(log T), and no digits are lost to forming Gram matrices (math.md 2.3). The rank is
/// at most n_x + 2 L, and so is r.
/// @throws ResponseOverflow if A (or A + B K) grows beyond what doubles resolve in T samples
ResponseRoot responseRoot(const ExplorationProblem& problem);

/// How much the modes of A (or A + B K) grow within T: spectral radius to the power T, from two
/// powers of the matrix, in O(log T); chains of integrators, which grow with powers of T, add a
/// factor of 4 each. Infinite where doubles overflow.
double modeGrowth(const ExplorationProblem& problem);

/// How much larger the responses to single components (and x_0) are than what is left of them in
/// their sum: the largest ratio over regressors and experiments.
/// @param amplitudes  carriers x n_u; several experiments one below the other
double cancellation(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes);

/// "A", or "A + B K"
std::string dynamicsName(const ExplorationProblem& problem);

/// "Stabilise with K ...", or with a K given already "Choose a K that stabilises ...".
std::string growthRemedy(const ExplorationProblem& problem);

}  // namespace explore_opt
