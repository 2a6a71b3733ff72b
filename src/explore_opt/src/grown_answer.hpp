/// Answers to problems whose modes grow within T: judged in long double before they are given.
#pragma once

#include <string>

#include "explore_opt/exploration_design.hpp"

namespace explore_opt {

/// From here on rounding counts: it is about 1e-16 of the growth, as a part of the information.
/// Long double has 2000 times finer digits, so nine of them hold up to a growth of about 1e10.
constexpr double kGrowthAudited = 1e5;

/// Simulates the answer by audit(). Amplitudes that fall short are scaled up once; cost, bound,
/// gap and peak become those of the simulation. Of an answer without amplitudes the bound is
/// judged.
/// @param growth  modeGrowth(problem)
/// @returns why the answer must be withdrawn; empty if it stands
std::string auditGrown(const ExplorationProblem& problem, const DesignOptions& options,
                       double growth, DesignResult& result);

}  // namespace explore_opt
