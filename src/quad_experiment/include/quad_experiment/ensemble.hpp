/// The same experiment with many seeds, to see where one run lies among them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "quad_experiment/experiment.hpp"

namespace quad_experiment {

/// Values by key (see comparedValues()) of seeds first_seed … first_seed + count - 1, in that order
/// whatever the number of workers.
/// @param progress  called with the number of seeds done, from one thread at a time
/// @throws what runExperiment() throws, of the lowest seed that failed
std::vector<std::map<std::string, double>> flySeeds(const ExperimentPlan& plan,
                                                    std::uint64_t first_seed, int count,
                                                    int workers,
                                                    const std::function<void(int)>& progress = {});

/// One key over all seeds: its sorted values.
std::vector<double> sortedValues(const std::vector<std::map<std::string, double>>& runs,
                                 const std::string& key);

/// Linear interpolation between order statistics; q in [0, 1]. Not a number if there are no values.
double quantile(const std::vector<double>& sorted, double q);

/// Share of values below, plus half of those equal, in per cent.
double percentileOf(const std::vector<double>& sorted, double value);

}  // namespace quad_experiment
