/// Designs that come again are computed once.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>

#include "explore_opt/exploration_design.hpp"

namespace quad_experiment {

/// The last designs of this process by their problem. A design is a function of its problem alone,
/// so remembering one changes no bit of what follows.
class DesignMemory {
 public:
  /// @param capacity  designs kept; the oldest goes first
  explicit DesignMemory(std::size_t capacity = 1000) : capacity_(capacity) {}

  /// designExploration(), without the iterations, which are of use only where they are printed.
  const explore_opt::DesignResult& design(const explore_opt::ExplorationProblem& problem,
                                          explore_opt::DesignMethod method);
  std::size_t computed() const { return computed_; }

 private:
  std::size_t capacity_, computed_ = 0;
  std::map<std::string, explore_opt::DesignResult> designs_;
  std::deque<std::string> order_;
};

}  // namespace quad_experiment
