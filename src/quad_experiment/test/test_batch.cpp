// Chunks: how they are cut, stored and merged; and that a thousand repeats are one flight.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "../src/batch/chunk_queue.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/sha256.hpp"
#include "spec_file.hpp"

using namespace quad_experiment;

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
