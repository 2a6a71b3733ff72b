/// The limit |u_k| <= u_max for all k, of which a solver only ever sees the few instants that bind.
#pragma once

#include <vector>

#include "design_tools.hpp"

namespace explore_opt {

/// Largest of ‖u_k‖/u_max (or |u_kj|/u_max,j) over the horizon.
double peakRatio(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes);

/// Local maxima of the predicted input above (1 - margin) u_max that are not in task.peaks yet, the
/// largest `most` of them, as constraints on the task's coordinates.
std::vector<PeakConstraint> bindingPeaks(const ExplorationProblem& problem, const DesignTask& task,
                                         const Eigen::MatrixXd& amplitudes, double margin,
                                         std::size_t most);

/// No amplitudes whose input respects u_max have a larger γ_e: from Σ_k ‖u_k‖² <= T Σ_j u_max,j².
double largestCost(const ExplorationProblem& problem, const DesignTask& task);

}  // namespace explore_opt
