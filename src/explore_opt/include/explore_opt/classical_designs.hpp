/// Input designs of the textbooks on the same lines: they maximise a number of the information
/// matrix and know nothing of the accuracy that is asked for.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// Of the information P⁻¹ on the unknown entries of [A B]; if none is known that is ΦΦᵀ ⊗ I, and
/// ΦΦᵀ stands for it.
enum class ClassicalCriterion {
  kD,  ///< largest det P⁻¹: least volume of the confidence ellipsoid
  kA,  ///< least tr P: least sum of variances
  kE,  ///< largest λ_min(P⁻¹): least longest axis; the same as targeting D_des = λ I
};

std::string toString(ClassicalCriterion criterion);  ///< "D-optimal", "A-optimal", "E-optimal"
std::vector<ClassicalCriterion> allCriteria();

/// Amplitudes of cost 1 (‖a‖, or what ExplorationProblem::cost says) that are best by the criterion
/// for the noise-free response of the nominal system from rest, transients included. D, A: BFGS
/// from several seeded starts, so a local optimum is possible; E: designExploration() with D_des =
/// I.
/// @returns carriers x n_u; empty if no direction excites all unknown parameters
Eigen::MatrixXd classicalDesign(const ExplorationProblem& problem, ClassicalCriterion criterion,
                                std::uint64_t seed = 1);

}  // namespace explore_opt
