/// The targeted signal against the ones in every textbook, at equal energy, on the same vehicle and
/// middleware.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "quad_experiment/experiment.hpp"

namespace quad_experiment {

/// One signal flown with one seed.
struct ComparedFlight {
  std::uint64_t seed = 0;
  double peak = 0.0;                     ///< largest |sample| [N]
  double energy = 0.0;                   ///< of the samples given [N^2]; equal for all signals
  std::optional<FlightVerdict> verdict;  ///< none if the simulation failed: `failure`
  std::string failure;
};

/// One signal over all seeds.
struct ComparedSignal {
  std::string name;         ///< "targeted", "gaussian", "line_8", …
  std::string description;  ///< one line
  std::vector<ComparedFlight> flights;
};

struct Comparison {
  double gamma_w = 0.0, desired_closeness = 0.0;
  std::vector<ComparedSignal> signals;  ///< by median lambda_min(S)/gamma_w, the largest first
};

/// Flies every signal with seeds config.seed … + seeds - 1. All signals of a seed meet the same
/// jitter; the random ones are drawn anew for each seed.
/// @param progress  called before each flight with the number of flights done and to do
Comparison compareSignals(const ExperimentConfig& config, int seeds,
                          const std::function<void(int, int)>& progress = {});

/// Quantile of a number over the flights of a signal that have it; not a number if none has.
double quantileOf(const ComparedSignal& signal, double q,
                  const std::function<std::optional<double>(const FlightVerdict&)>& number);
/// Share of all flights of which it is true; failed flights count as false.
double shareOf(const ComparedSignal& signal, const std::function<bool(const FlightVerdict&)>& is);

nlohmann::ordered_json comparisonJson(const ExperimentConfig& config, const Comparison& comparison);
std::string comparisonCsv(const Comparison& comparison);   ///< a row a flight
std::string comparisonText(const Comparison& comparison);  ///< a line a signal, and what it means

}  // namespace quad_experiment
