#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "quad_experiment/comparison.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "scratch.hpp"

using namespace quad_experiment;

namespace {

const ComparedSignal& named(const Comparison& comparison, const std::string& name) {
  for (const ComparedSignal& signal : comparison.signals) {
    if (signal.name == name) return signal;
  }
  throw std::out_of_range(name);
}

const auto kInformation = [](const FlightVerdict& v) {
  return v.set ? std::optional<double>(v.set->lambda_min_S) : std::nullopt;
};

}  // namespace

TEST(Comparison, AllSignalsHaveTheSameEnergyAndMeetTheSameNoise) {
  const ExperimentConfig config = readExperimentConfig("config/smoke.yaml");
  const Comparison comparison = compareSignals(config, 3);
  std::set<std::string> names;
  const double energy = named(comparison, "targeted").flights[0].energy;
  for (const ComparedSignal& signal : comparison.signals) {
    SCOPED_TRACE(signal.name);
    names.insert(signal.name);
    ASSERT_EQ(signal.flights.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      // Scaling T = 40 samples rounds each square by a few eps.
      EXPECT_NEAR(signal.flights[i].energy, energy, 1e-12 * energy);
      EXPECT_EQ(signal.flights[i].seed, config.seed + i);
      ASSERT_TRUE(signal.flights[i].verdict);
      // The least peak a signal of this energy can have is its root mean square.
      EXPECT_GE(signal.flights[i].peak, std::sqrt(energy / 40.0) * (1.0 - 1e-12));
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"targeted", "gaussian", "band_limited", "random_phase",
                                          "chirp", "prbs", "line_1", "line_2", "line_3"}));
  const auto& drawn = named(comparison, "gaussian").flights;
  EXPECT_NE(drawn[0].peak, drawn[1].peak);
  const auto& fixed = named(comparison, "targeted").flights;
  EXPECT_EQ(fixed[0].peak, fixed[1].peak);
  EXPECT_NE(fixed[0].verdict->gamma_w_exp, fixed[1].verdict->gamma_w_exp);  // another jitter
}

TEST(Comparison, RanksByInformationAndNeverByTheBound) {
  const Comparison comparison = compareSignals(readExperimentConfig("config/thesis.yaml"), 2);
  bool bound_would_rank_otherwise = false;
  for (std::size_t i = 1; i < comparison.signals.size(); ++i) {
    const ComparedSignal &above = comparison.signals[i - 1], &below = comparison.signals[i];
    EXPECT_GE(quantileOf(above, 0.5, kInformation), quantileOf(below, 0.5, kInformation));
    const auto bound = [](const FlightVerdict& v) {
      return v.set ? v.set->lambdaBound() : std::nullopt;
    };
    bound_would_rank_otherwise |= quantileOf(above, 0.5, bound) < quantileOf(below, 0.5, bound);
  }
  EXPECT_TRUE(bound_would_rank_otherwise);  // so that the order above says something
}

TEST(Comparison, TargetedIsTheTargetedFlightOfARun) {
  const ExperimentConfig config = readExperimentConfig("config/smoke.yaml");
  const Comparison comparison = compareSignals(config, 1);
  const ExperimentPlan plan = planExperiment(config);
  InProcessPlant plant(config);
  const FlightResult flight = flyAndJudge(plan, plant, kTargetedFlight);
  const FlightVerdict& compared = *named(comparison, "targeted").flights[0].verdict;
  EXPECT_EQ(compared.gamma_w_exp, flight.verdict.gamma_w_exp);
  EXPECT_EQ(compared.error_norm, flight.verdict.error_norm);
}

TEST(Comparison, FilesTellTheSame) {
  const ExperimentConfig config = readExperimentConfig("config/smoke.yaml");
  const Comparison comparison = compareSignals(config, 2);
  const auto j = comparisonJson(config, comparison);
  ASSERT_EQ(j["signals"].size(), comparison.signals.size());
  EXPECT_EQ(j["signals"][0]["name"], comparison.signals[0].name);
  EXPECT_EQ(j["signals"][0]["lambda_min_S_over_gamma_w"].get<double>(),
            j["signals"][0]["lambda_min_S"]["median"].get<double>() / config.design.gamma_w);
  const std::string csv = comparisonCsv(comparison);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
            1 + 2 * static_cast<long>(comparison.signals.size()));
  EXPECT_NE(comparisonText(comparison).find("ranked by lambda_min(S)/gamma_w"), std::string::npos);
}
