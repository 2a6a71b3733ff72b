/// Input designs of the textbooks on the same lines: they maximise a number of the information
/// matrix and know nothing of the accuracy that is asked for.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

enum class ClassicalCriterion {
  kD,  ///< largest det(ΦΦᵀ): least volume of the confidence ellipsoid
  kA,  ///< least tr((ΦΦᵀ)⁻¹): least sum of variances
  kE,  ///< largest λ_min(ΦΦᵀ): least longest axis; the same as targeting D_des = λ I
};

std::string toString(ClassicalCriterion criterion);  ///< "D-optimal", "A-optimal", "E-optimal"
std::vector<ClassicalCriterion> allCriteria();

/// Direction of amplitudes, ‖a‖ = 1, that is best by the criterion for the noise-free response of
/// the nominal system, transients included. D, A: BFGS from several seeded starts, so a local
/// optimum is possible; E: designExploration() with D_des = I.
/// @returns carriers x n_u; empty if no direction excites all parameters
Eigen::MatrixXd classicalDesign(const ExplorationProblem& problem, ClassicalCriterion criterion,
                                std::uint64_t seed = 1);

}  // namespace explore_opt
