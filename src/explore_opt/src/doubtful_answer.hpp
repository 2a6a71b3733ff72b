/// Answers that doubles may not have had the digits for: judged in long double before they are
/// given.
#pragma once

#include <optional>
#include <string>

#include "explore_opt/exploration_design.hpp"

namespace explore_opt {

/// Why an answer is judged, in terms of the problem.
struct Doubt {
  std::string cause;   ///< "the modes of A grow 1e+09-fold within T = 370"
  std::string remedy;  ///< what the user can do about it
};

/// Modes that grow within T, single responses that all but cancel in their sum (integrators over
/// long times), a cost below its bound. Rounding is about 1e-16 of the growth, or of what cancels,
/// as a part of the information; from 1e5 on it counts. Long double has 2000 times finer digits, so
/// nine of them hold up to about 1e10.
std::optional<Doubt> doubtOf(const ExplorationProblem& problem, const DesignResult& result);

/// Simulates the answer by audit(). Amplitudes that fall short are scaled up once; cost, bound,
/// gap and peak become those of the simulation. Of an answer without amplitudes the bound is
/// judged.
/// @returns why the answer must be withdrawn; empty if it stands
std::string auditAnswer(const ExplorationProblem& problem, const DesignOptions& options,
                        const Doubt& doubt, DesignResult& result);

}  // namespace explore_opt
