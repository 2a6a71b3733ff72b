#include "quad_experiment/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "explore_opt/baseline_signals.hpp"
#include "quad_experiment/ensemble.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"

namespace quad_experiment {
namespace {

using explore_opt::BaselineKind;

/// A signal for each seed.
struct Candidate {
  std::string name, description;
  std::function<std::vector<double>(std::uint64_t seed)> samples;
};

/// A baseline of the targeted signal's energy, in the band of the design's lines.
Candidate baseline(const ExperimentPlan& plan, double energy, BaselineKind kind,
                   const std::string& name, const std::string& description,
                   const explore_opt::SpectralLines& lines = {}) {
  const std::vector<int>& harmonics = plan.config.design.harmonics;
  const double samples = plan.config.design.num_samples;
  explore_opt::BaselineSpec spec;
  spec.kind = kind;
  spec.num_samples = plan.config.design.num_samples;
  spec.energy = energy;
  spec.band_low = *std::min_element(harmonics.begin(), harmonics.end()) / samples;
  spec.band_high = *std::max_element(harmonics.begin(), harmonics.end()) / samples;
  if (spec.band_low == spec.band_high) spec.band_low = 1.0 / samples;
  spec.lines = lines;
  spec.line_phase = plan.config.design.phase == explore_opt::Phase::kCos ? explore_opt::Phase::kCos
                                                                         : explore_opt::Phase::kSin;
  // The usual rule: a clock of 2.5 times the highest frequency of interest.
  if (kind == BaselineKind::kPrbs)
    spec.hold = std::max(1, static_cast<int>(std::lround(1.0 / (2.5 * spec.band_high))));
  spec.stream = kCompareStreams + static_cast<std::uint64_t>(kind);
  return {name, description, [spec](std::uint64_t seed) mutable {
            spec.seed = seed;
            const Eigen::MatrixXd U = explore_opt::baselineSignal(spec);
            return std::vector<double>(U.data(), U.data() + U.size());
          }};
}

std::vector<Candidate> candidates(const ExperimentPlan& plan) {
  double energy = 0.0;
  for (const double u : plan.targeted_signal) energy += u * u;
  const auto& d = plan.config.design;
  const auto lines = [&](std::vector<int> harmonics) {
    explore_opt::SpectralLines l;
    l.num_samples = d.num_samples;
    l.harmonics = std::move(harmonics);
    return l;
  };
  std::vector<Candidate> all;
  all.push_back({"targeted", d.fly_design ? "the certified design" : "the amplitudes given",
                 [&plan](std::uint64_t) { return plan.targeted_signal; }});
  all.push_back(baseline(plan, energy, BaselineKind::kWhite, "gaussian", "white Gaussian noise"));
  all.push_back(baseline(plan, energy, BaselineKind::kBandLimited, "band_limited",
                         "Gaussian noise in the band of the design's lines"));
  all.push_back(baseline(plan, energy, BaselineKind::kRandomPhase, "random_phase",
                         "the design's lines, equal amplitudes, random phases",
                         lines(d.harmonics)));
  all.push_back(baseline(plan, energy, BaselineKind::kChirp, "chirp",
                         "linear sweep over the band of the design's lines"));
  all.push_back(baseline(plan, energy, BaselineKind::kPrbs, "prbs",
                         "binary noise, clocked at 2.5 times the highest line"));
  for (const int h : d.harmonics) {
    all.push_back(baseline(plan, energy, BaselineKind::kLine, fmt::format("line_{}", h),
                           fmt::format("the single line {}/{}", h, d.num_samples), lines({h})));
  }
  return all;
}

ComparedFlight flyOnce(const ExperimentPlan& plan, Plant& plant, const quad_control::Mixer& mixer,
                       const std::vector<double>& samples, std::uint64_t seed) {
  ComparedFlight flight;
  flight.seed = seed;
  for (const double u : samples) {
    flight.peak = std::max(flight.peak, std::abs(u));
    flight.energy += u * u;
  }
  const Middleware middleware(middlewareConfig(plan.config), seed, kTargetedFlight);
  try {
    const Trajectory flown = fly(plant, flightSpec(plan, samples, middleware), middleware);
    flight.verdict = judgeFlight(
        plan.knowledge, explorationData(flown, mixer, plan.knowledge.feedforward()), flown);
  } catch (const quad_support::SimulationError& e) {
    flight.failure = e.what();
  }
  return flight;
}

double informationOf(const ComparedSignal& signal) {
  return quantileOf(signal, 0.5, [](const FlightVerdict& v) {
    return v.set ? std::optional<double>(v.set->lambda_min_S) : std::nullopt;
  });
}

}  // namespace

Comparison compareSignals(const ExperimentConfig& config, int seeds,
                          const std::function<void(int, int)>& progress) {
  const ExperimentPlan plan = planExperiment(config);
  const quad_control::Mixer mixer(quad_control::rotorGeometry(plan.config.vehicle()));
  InProcessPlant plant(config);
  Comparison comparison;
  comparison.gamma_w = config.design.gamma_w;
  comparison.desired_closeness = config.design.desired_closeness;
  const std::vector<Candidate> all = candidates(plan);
  int done = 0;
  for (const Candidate& candidate : all) {
    ComparedSignal signal{candidate.name, candidate.description, {}};
    for (int i = 0; i < seeds; ++i, ++done) {
      if (progress) progress(done, static_cast<int>(all.size()) * seeds);
      const std::uint64_t seed = config.seed + static_cast<std::uint64_t>(i);
      signal.flights.push_back(flyOnce(plan, plant, mixer, candidate.samples(seed), seed));
    }
    comparison.signals.push_back(std::move(signal));
  }
  std::stable_sort(comparison.signals.begin(), comparison.signals.end(),
                   [](const ComparedSignal& a, const ComparedSignal& b) {
                     const double of_a = informationOf(a), of_b = informationOf(b);
                     return std::isnan(of_b) ? !std::isnan(of_a) : of_a > of_b;
                   });
  return comparison;
}

double quantileOf(const ComparedSignal& signal, double q,
                  const std::function<std::optional<double>(const FlightVerdict&)>& number) {
  std::vector<double> values;
  for (const ComparedFlight& flight : signal.flights) {
    const auto value = flight.verdict ? number(*flight.verdict) : std::nullopt;
    if (value && std::isfinite(*value)) values.push_back(*value);
  }
  std::sort(values.begin(), values.end());
  return quantile(values, q);
}

double shareOf(const ComparedSignal& signal, const std::function<bool(const FlightVerdict&)>& is) {
  const auto count = std::count_if(
      signal.flights.begin(), signal.flights.end(),
      [&](const ComparedFlight& flight) { return flight.verdict && is(*flight.verdict); });
  return static_cast<double>(count) / static_cast<double>(signal.flights.size());
}

}  // namespace quad_experiment
