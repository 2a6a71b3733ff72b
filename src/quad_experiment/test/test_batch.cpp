#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "../src/batch/chunk_queue.hpp"
#include "quad_experiment/batch.hpp"
#include "quad_experiment/batch_row.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/sha256.hpp"
#include "scratch.hpp"

using namespace quad_experiment;

namespace {

/// A spec on config/smoke.yaml in a folder of its own.
class SpecFile {
 public:
  explicit SpecFile(const std::string& rest) {
    quad_support::writeFileAtomically(scratch_.path("smoke.yaml"), shippedConfig("smoke.yaml"));
    quad_support::writeFileAtomically(path(), "base: smoke.yaml\n" + rest);
  }
  std::string path() const { return scratch_.path("spec.yaml"); }
  std::string in(const std::string& name) const { return scratch_.path(name); }
  BatchSpec read(std::int64_t repeats = 0) const { return readBatchSpec(path(), repeats); }

 private:
  Scratch scratch_;
};

std::string valueOf(const BatchSpec& spec, std::int64_t run, const std::string& key) {
  for (const auto& setting : spec.variedSettings(run)) {
    if (setting.key == key) return setting.value;
  }
  return "";
}

std::string complaint(const std::string& rest) {
  try {
    SpecFile(rest).read();
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

std::string rows(const BatchSpec& spec, RunRange runs) {
  std::string text;
  DesignMemory designs;
  for (std::int64_t run = runs.first; run < runs.last; ++run)
    text += flyBatchRun(spec, run, designs);
  return text;
}

}  // namespace

TEST(BatchSpec, GridIsTraversedWithTheLastKeyFastest) {
  const BatchSpec spec = SpecFile(
                             "seed: 1\nruns: 2\nvary:\n  design.gamma_w: {grid: [4, 5]}\n  "
                             "timing.latency: {grid: [0.0, 0.01, 0.02]}\n"
                             "  seed: {count: 7, common: true}\n")
                             .read();
  EXPECT_EQ(spec.points, 6);
  EXPECT_EQ(spec.runs(), 12);
  EXPECT_EQ(valueOf(spec, 1, "design.gamma_w"), "4");
  EXPECT_EQ(valueOf(spec, 1, "timing.latency"), "0.01");
  EXPECT_EQ(valueOf(spec, 9, "design.gamma_w"), "5");
  EXPECT_EQ(valueOf(spec, 9, "timing.latency"), "0.0");
  EXPECT_EQ(valueOf(spec, 5, "seed"), "7");  // common: one seed for all points of a repeat
  EXPECT_EQ(valueOf(spec, 6, "seed"), "8");
}

TEST(BatchSpec, DrawsDependOnKeyAndRunAlone) {
  const std::string mass = "  vehicle.mass: {uniform: [0.7, 0.76]}\n";
  const BatchSpec one = SpecFile("seed: 1\nruns: 10\nvary:\n" + mass).read();
  const BatchSpec more = SpecFile(
                             "seed: 1\nruns: 20\nvary:\n  seed: {count: 1}\n  timing.jitter_std: "
                             "{uniform: [0.0, 0.01]}\n" +
                             mass)
                             .read();
  const BatchSpec other = SpecFile("seed: 2\nruns: 10\nvary:\n" + mass).read();
  std::set<std::string> seen;
  for (int run = 0; run < 10; ++run) {
    const std::string value = valueOf(one, run, "vehicle.mass");
    EXPECT_EQ(value, valueOf(more, run, "vehicle.mass"));
    EXPECT_NE(value, valueOf(other, run, "vehicle.mass"));
    EXPECT_TRUE(seen.insert(value).second);
  }
}

// Means of n draws lie within 5 standard deviations of the mean of the law, whose chance is below
// 1e-6; the draws are fixed, so this passes always or never.
TEST(BatchSpec, DrawsFollowTheirLaws) {
  const BatchSpec spec =
      SpecFile(
          "seed: 3\nruns: 4000\nvary:\n  vehicle.mass: {normal: [0.73, 0.02], min: 0.72}\n"
          "  design.gamma_w: {log_uniform: [1, 100]}\n  control.hold_time: {uniform: [1, 3]}\n"
          "  seed: {integer: [3, 5]}\n  control.altitude[1]: {choice: [0.5, 0.7]}\n")
          .read();
  constexpr int kDraws = 4000;
  double mass = 0, log_gamma = 0, hold = 0;
  std::map<std::string, int> seeds, gains;
  for (int run = 0; run < kDraws; ++run) {
    const double m = std::stod(valueOf(spec, run, "vehicle.mass"));
    EXPECT_GE(m, 0.72);
    mass += m / kDraws;
    log_gamma += std::log10(std::stod(valueOf(spec, run, "design.gamma_w"))) / kDraws;
    hold += std::stod(valueOf(spec, run, "control.hold_time")) / kDraws;
    ++seeds[valueOf(spec, run, "seed")];
    ++gains[valueOf(spec, run, "control.altitude[1]")];
  }
  const double n = std::sqrt(kDraws);
  EXPECT_NEAR(mass, 0.73 + 0.02 * 0.509160,
              5 * 0.02 / n);  // truncated at -0.5 sigma: phi/Phi = 0.50916
  EXPECT_NEAR(log_gamma, 1.0, 5 * 0.5774 / n);
  EXPECT_NEAR(hold, 2.0, 5 * 0.5774 / n);
  ASSERT_EQ(seeds.size(), 3u);
  for (const auto& [seed, count] : seeds) EXPECT_NEAR(count, kDraws / 3.0, 5 * 0.4714 * n) << seed;
  EXPECT_NEAR(gains["0.5"], kDraws / 2.0, 5 * 0.5 * n);
}

TEST(BatchSpec, ComplaintsNameTheKey) {
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  design.gamma: {grid: [1]}\n")
                .find("design.gamma is not a key of this program"),
            std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 0\nvary: {}\n")
                .find("spec.yaml:3: runs = 0; must be a whole number in 1.."),
            std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  seed: 4\n")
                .find("spec.yaml:5: vary.seed = 4; must say how it varies"),
            std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  seed: {gamma: [1, 2]}\n")
                .find("vary.seed.gamma is not a key"),
            std::string::npos);
  EXPECT_NE(
      complaint("seed: 1\nruns: 1\nvary:\n  vehicle.mass: {uniform: [2, 1]}\n").find("low <= high"),
      std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  vehicle.mass: {uniform: [1, 2], grid: [1]}\n")
                .find("stands beside"),
            std::string::npos);
  const std::string negative = complaint("seed: 1\nruns: 1\nset: {design.gamma_w: -1}\nvary: {}\n");
  EXPECT_NE(negative.find("run 0: "), std::string::npos) << negative;
  EXPECT_NE(negative.find("design.gamma_w = -1; must be > 0"), std::string::npos) << negative;
}

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

TEST(ChunkQueue, HalvesUntilThePoisonIsAlone) {
  ChunkQueue queue({{0, 100}});
  constexpr int kPoison = 37;
  std::set<std::int64_t> flown, crashed;
  int deaths = 0;
  while (!queue.empty()) {
    const Chunk chunk = queue.take(40);
    if (chunk.runs.first <= kPoison && kPoison < chunk.runs.last) {
      ++deaths;
      if (const auto run = queue.died(chunk)) crashed.insert(*run);
    } else {
      for (std::int64_t run = chunk.runs.first; run < chunk.runs.last; ++run)
        EXPECT_TRUE(flown.insert(run).second);
    }
  }
  EXPECT_EQ(crashed, std::set<std::int64_t>{kPoison});
  EXPECT_EQ(flown.size(), 99u);
  EXPECT_LE(deaths,
            9);  // two for the chunk, then one for each halving of 40, rounded up, and one alone
}

TEST(ChunkQueue, AWorkerKilledOnceCostsNoRun) {
  ChunkQueue queue({{0, 4}});
  EXPECT_FALSE(queue.died(queue.take(4)));
  const Chunk again = queue.take(1);
  EXPECT_EQ(again.runs.size(), 4);
}

TEST(BatchStore, ChunksOfAnySizeMergeToTheSameTable) {
  const SpecFile file("seed: 1\nruns: 6\nvary:\n  seed: {count: 1}\n");
  const BatchSpec spec = file.read();
  std::string merged;
  for (const auto& cuts : std::vector<std::vector<std::int64_t>>{{0, 6}, {0, 1, 2, 6}, {0, 4, 6}}) {
    const std::string out = file.in("out" + std::to_string(cuts.size()) + std::to_string(cuts[1]));
    BatchStore store(spec, out, IfBatchExists::kRefuse, "");
    for (std::size_t i = cuts.size() - 1; i > 0; --i) {
      EXPECT_FALSE(store.merge());
      store.writeChunk({cuts[i - 1], cuts[i]}, rows(spec, {cuts[i - 1], cuts[i]}));
    }
    store.writeChunk({1, 3},
                     rows(spec, {1, 3}));  // flown twice, as two shards of different cuts may
    ASSERT_TRUE(store.merge());
    const std::string table = quad_support::readFile(store.resultsPath());
    if (merged.empty()) merged = table;
    EXPECT_EQ(table, merged);
  }
  EXPECT_EQ(std::count(merged.begin(), merged.end(), '\n'), 7);
}

TEST(BatchStore, ADamagedChunkIsFlownAgain) {
  const SpecFile file("seed: 1\nruns: 4\nvary:\n  seed: {count: 1}\n");
  const BatchSpec spec = file.read();
  BatchStore store(spec, file.in("out"), IfBatchExists::kRefuse, "");
  store.writeChunk({0, 2}, rows(spec, {0, 2}));
  store.writeChunk({2, 4}, rows(spec, {2, 4}));
  EXPECT_TRUE(store.missing({0, 4}).empty());
  const std::string path = file.in("out/chunks/0000000002-0000000004.csv");
  std::string text = quad_support::readFile(path);
  text[text.size() / 2] ^= 1;
  quad_support::writeFileAtomically(path, text);
  EXPECT_THROW(store.merge(), quad_support::EnvironmentError);
  const auto missing = store.missing({0, 4});
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].first, 2);
  EXPECT_EQ(missing[0].last, 4);
}

TEST(BatchStore, KnowsItsSpec) {
  const SpecFile file("seed: 1\nruns: 4\nvary:\n  seed: {count: 1}\n");
  const BatchSpec spec = file.read(), longer = file.read(5);
  { BatchStore store(spec, file.in("out"), IfBatchExists::kRefuse, ""); }
  EXPECT_THROW(BatchStore(spec, file.in("out"), IfBatchExists::kRefuse, ""), std::invalid_argument);
  EXPECT_THROW(BatchStore(longer, file.in("out"), IfBatchExists::kResume, ""),
               quad_support::ConfigError);
  {
    BatchStore first(spec, file.in("out"), IfBatchExists::kResume, "");
    EXPECT_THROW(BatchStore(spec, file.in("out"), IfBatchExists::kResume, ""),
                 quad_support::EnvironmentError);
    BatchStore shard(spec, file.in("out"), IfBatchExists::kResume, "-1-of-2");
  }
  BatchStore replaced(longer, file.in("out"), IfBatchExists::kReplace, "");
  std::filesystem::create_directory(file.in("mine"));
  quad_support::writeFileAtomically(file.in("mine/notes"), "mine");
  EXPECT_THROW(BatchStore(spec, file.in("mine"), IfBatchExists::kReplace, ""),
               std::invalid_argument);
}

TEST(Shards, CoverAllRunsOnce) {
  for (const int shards : {1, 3, 7, 20}) {
    std::int64_t next = 0;
    for (int i = 1; i <= shards; ++i) {
      EXPECT_EQ(shardRuns(11, i, shards).first, next);
      next = shardRuns(11, i, shards).last;
    }
    EXPECT_EQ(next, 11);
  }
}

// QUAD_LONG_TESTS=1: a thousand repeats, about two minutes.
TEST(Determinism, ExactRepeatsInOneProcessGiveOneHash) {
  const int repeats = std::getenv("QUAD_LONG_TESTS") ? 1000 : 5;
  const ExperimentConfig config = readExperimentConfig("config/exact.yaml");
  const ExperimentPlan plan = planExperiment(config);
  const quad_control::Mixer mixer(quad_control::rotorGeometry(plan.config.vehicle()));
  std::set<std::string> hashes;
  InProcessPlant kept(config);
  for (int i = 0; i < repeats; ++i) {
    InProcessPlant fresh(config);  // in turns a plant that has flown and a new one
    for (const Flight flight : {kTargetedFlight, kGaussianFlight}) {
      const FlightResult result = flyAndJudge(plan, i % 2 ? fresh : kept, flight);
      hashes.insert(
          std::to_string(flight) +
          quad_support::sha256(toCsv(result.trajectory, mixer, plan.knowledge.feedforward())));
    }
  }
  EXPECT_EQ(hashes.size(), 2u);  // one a flight
}
