/// The global method where u_max limits the input's peaks.
#pragma once

#include "design_tools.hpp"

namespace explore_opt {

/// The horizon has too many instants to limit them all: those where a candidate's peaks are, are
/// added one after the other until the limit holds at all of them. From outside the limit a start
/// first descends towards the least peak.
/// @param free  the design without u_max: its amplitudes, and a bound that holds here too
RawDesign designWithinPeaks(const ExplorationProblem& problem, const DesignTask& single,
                            const DesignOptions& options, RawDesign free);

}  // namespace explore_opt
