// Rows: what an experiment said, failures, everything a study varies, designs that come again.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"
#include "spec_file.hpp"

using namespace quad_experiment;

TEST(BatchRow, SaysWhatTheExperimentSaid) {
  const SpecFile file(
      "seed: 1\nruns: 3\nvary:\n  seed: {count: 4}\n  design.harmonics: {choice: [[1, 2, 3]]}\n");
  const BatchSpec spec = file.read();
  const std::vector<std::string> columns = batchColumns(spec);
  const std::vector<std::string> cells = splitBatchRow(rows(spec, {2, 3}));
  ASSERT_EQ(cells.size(), columns.size());
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < cells.size(); ++i) row[columns[i]] = cells[i];
  EXPECT_EQ(row["run"], "2");
  EXPECT_EQ(row["seed"], "6");
  EXPECT_EQ(row["design.harmonics"], "[1, 2, 3]");

  const ExperimentConfig config = spec.experiment(2);
  quad_support::ResultDirectory results(file.in("out"), false);
  InProcessPlant plant(config);
  const ExperimentResult result = runExperiment(config, {&plant}, "in_process", results);
  const auto summary =
      nlohmann::json::parse(quad_support::readFile(results.workPath() + "/summary.json"));
  EXPECT_EQ(row["exit_code"], std::to_string(result.exitCode()));
  EXPECT_EQ(std::stod(row["targeted.B2"]), summary["targeted"]["B"][1][0].get<double>());
  EXPECT_EQ(std::stod(row["random.gamma_w_exp"]), summary["random"]["gamma_w_exp"].get<double>());
}

// Pythagoras: the truth lies in the set exactly when gamma_w,exp <= gamma_w, for any data. gamma_w
// is drawn around the energies that occur, so that both happen.
TEST(BatchRow, TheTruthLiesInTheSetExactlyWhenGammaWHolds) {
  const BatchSpec spec = SpecFile(
                             "seed: 1\nruns: 60\nvary:\n  seed: {count: 1}\n  design.gamma_w: "
                             "{log_uniform: [0.01, 1]}\n"
                             "  timing.latency: {uniform: [0.0, 0.09]}\nset: {comparison: []}\n")
                             .read();
  const std::vector<std::string> columns = batchColumns(spec);
  std::map<std::string, int> seen;
  DesignMemory designs;
  for (int run = 0; run < 60; ++run) {
    const auto cells = splitBatchRow(flyBatchRun(spec, run, designs));
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < cells.size(); ++i) row[columns[i]] = cells[i];
    EXPECT_EQ(row["targeted.truth_in_set"], row["targeted.gamma_w_valid"]) << run;
    ++seen[row["targeted.truth_in_set"]];
  }
  EXPECT_GE(seen["0"], 5);
  EXPECT_GE(seen["1"], 5);
}

TEST(BatchRow, FailuresAreRows) {
  const auto statusOf = [](const std::string& set) {
    const BatchSpec spec =
        SpecFile("seed: 1\nruns: 1\nvary:\n  seed: {count: 1}\nset:\n" + set).read();
    const auto cells = splitBatchRow(rows(spec, {0, 1}));
    return cells[2] + " " + cells[3];
  };
  EXPECT_EQ(statusOf("  simulation.initial_altitude: 0.5\n  estimate.mass: 0.5\n"),
            "ground_contact 4");
  EXPECT_EQ(statusOf("  design.gamma_w: 1e300\n  design.desired_closeness: 1e300\n"),
            "infeasible 3");
  EXPECT_EQ(statusOf("  design.signal: given\n  design.amplitudes: [1e-3, 1e-3, 1e-3]\n"),
            "condition_not_met 3");
  EXPECT_EQ(statusOf("  design.gamma_w: 1e-3\n"), "falsified 3");
}

// Each of them reaches the flight or the design: the numbers of its two rows differ. There is some
// wind, so that the controllers have something to hold against.
TEST(BatchRow, WhatAStudyVaries) {
  const auto numbersOf = [](const std::string& vary) {
    const BatchSpec spec = SpecFile(
                               "seed: 1\nruns: 1\nset: {simulation.wind: {force: 0.1, direction: "
                               "[0, 0, 1]}}\nvary:\n  " +
                               vary)
                               .read();
    DesignMemory designs;
    std::array<std::string, 2> numbers;
    for (int run = 0; run < 2; ++run) {
      const auto cells = splitBatchRow(flyBatchRun(spec, run, designs));
      for (std::size_t i = 2; i < cells.size(); ++i)
        numbers[static_cast<std::size_t>(run)] += cells[i] + ",";
    }
    return numbers;
  };
  for (const char* vary :
       {"vehicle.mass: {grid: [0.73, 0.74]}", "estimate.mass: {grid: [0.70, 0.71]}",
        "seed: {grid: [1, 2]}", "timing.latency: {grid: [0.02, 0.045]}",
        "timing.jitter_std: {grid: [0.002, 0.005]}", "design.gamma_w: {grid: [4, 5]}",
        "design.desired_closeness: {grid: [10, 12]}",
        "simulation.initial_altitude: {grid: [5000, 5001]}",
        "simulation.wind.force: {grid: [0.1, 0.2]}",
        "simulation.wind: {grid: [{}, {gust_force: 0.5, gust_direction: [0, 0, 1], gust_start: "
        "2, gust_duration: 1}]}",
        "simulation.wind: {grid: [{speed: 2}, {speed: 4}]}",
        "control.altitude: {grid: [[2.4, 0.7, 2.4, 0.6], [2, 0.5, 2, 0.5]]}",
        "control.altitude[0]: {grid: [2.4, 2.0]}", "design.method: {grid: [global, mm]}"}) {
    const auto numbers = numbersOf(vary + std::string("\n"));
    EXPECT_NE(numbers[0], numbers[1]) << vary;
    EXPECT_EQ(numbers[0].find("bad_input"), std::string::npos) << vary;
    EXPECT_EQ(numbers[1].find("bad_input"), std::string::npos) << vary;
  }
}

TEST(BatchRow, ADrawThatIsNoExperimentIsARow) {
  const BatchSpec spec =
      SpecFile("seed: 1\nruns: 1\nvary:\n  design.gamma_w: {grid: [4, -1]}\n").read();
  const auto cells = splitBatchRow(rows(spec, {1, 2}));
  EXPECT_EQ(cells[2] + " " + cells[3], "bad_input 2");
}

TEST(DesignMemory, ADesignThatComesAgainIsComputedOnce) {
  const BatchSpec spec =
      SpecFile(
          "seed: 1\nruns: 2\nvary:\n  seed: {count: 1}\n  timing.latency: {grid: [0.0, 0.01]}\n"
          "  design.gamma_w: {grid: [4, 5]}\n")
          .read();
  DesignMemory designs;
  std::string with;
  for (int run = 0; run < 8; ++run) with += flyBatchRun(spec, run, designs);
  EXPECT_EQ(designs.computed(), 2u);
  std::string without;
  for (int run = 0; run < 8; ++run) {
    DesignMemory fresh;
    without += flyBatchRun(spec, run, fresh);
  }
  EXPECT_EQ(with, without);
}
