#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "commands.hpp"
#include "quad_experiment/batch.hpp"
#include "quad_experiment/batch_row.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

using namespace quad_experiment;
using Json = nlohmann::ordered_json;

namespace {

/// "2/8" as {2, 8}.
std::pair<int, int> parseShard(const std::string& text) {
  int shard = 0, shards = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &shard, &shards, &rest) != 2 || shards < 1 ||
      shard < 1 || shard > shards)
    throw quad_support::ConfigError("--shard " + text +
                                    ": must be i/n with 1 <= i <= n, for instance 2/8");
  return {shard, shards};
}

IfBatchExists ifExists(const BatchCommandOptions& o) {
  if (o.force) return IfBatchExists::kReplace;
  // The other shards of a batch fill the same directory, so that it exists means nothing.
  return o.resume || !o.shard.empty() ? IfBatchExists::kResume : IfBatchExists::kRefuse;
}

/// The spec, number of repeats and hash that a batch's directory was begun with.
BatchSpec specOf(const std::string& batch) {
  const Json j = Json::parse(quad_support::readFile(batch + "/manifest.json"), nullptr, false);
  if (!j.is_object() || !j.contains("spec") || !j.contains("repeats") || !j.contains("hash"))
    throw quad_support::ConfigError(batch + "/manifest.json: is no manifest of a batch");
  BatchSpec spec = readBatchSpec(j["spec"].get<std::string>(), j["repeats"].get<std::int64_t>());
  if (spec.hash != j["hash"].get<std::string>())
    throw quad_support::ConfigError(
        batch +
        ": its spec, settings file, vehicle or the program has changed since; give --spec to fly "
        "the run as it would be now");
  return spec;
}

/// The row of a run in a merged table.
std::string rowIn(const std::string& results_csv, std::int64_t run) {
  const std::string text = quad_support::readFile(results_csv);
  const auto at = text.find(fmt::format("\n{},", run));
  if (at == std::string::npos)
    throw quad_support::ConfigError(fmt::format("{}: has no run {}", results_csv, run));
  return text.substr(at + 1, text.find('\n', at + 1) - at);
}

}  // namespace

int batch(const BatchCommandOptions& o) {
  if (o.spec.empty() || o.out.empty())
    throw std::invalid_argument("batch needs --spec and --out; see quad_experiment batch --help");
  const auto [shard, shards] = o.shard.empty() ? std::pair(1, 1) : parseShard(o.shard);
  const BatchSpec spec = readBatchSpec(o.spec, o.runs);
  BatchOptions options;
  options.out = o.out;
  options.exists = ifExists(o);
  options.workers = o.workers > 0
                        ? o.workers
                        : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  options.chunk = o.chunk;
  options.timeout = o.timeout;
  options.shard = shard;
  options.shards = shards;
  if (!runBatch(spec, options)) {
    std::printf("shard %d of %d is done; results.csv is written when the last one is\n", shard,
                shards);
    return quad_support::kDone;
  }
  const std::string results = o.out + "/results.csv";
  tellResults(batchDigest(results) + "\n", results);
  return quad_support::kDone;
}

int batchDescribe(const BatchCommandOptions& o) {
  const BatchSpec spec = readBatchSpec(o.spec, o.runs);
  const Json j = {{"runs", spec.runs()},     {"points", spec.points},
                  {"repeats", spec.repeats}, {"settings", spec.base_path},
                  {"hash", spec.hash},       {"columns", batchColumns(spec)}};
  std::printf("%s\n", j.dump(2).c_str());
  return quad_support::kDone;
}

int batchWorker(const BatchCommandOptions& o) {
  const BatchSpec spec = readBatchSpec(o.spec, o.runs);
  if (spec.hash != o.hash)
    throw quad_support::ConfigError(o.spec + ": has changed since the batch was begun");
  return serveBatch(spec, o.out);
}

int batchReplay(const BatchReplayOptions& o) {
  if (o.spec.empty() == o.batch.empty())
    throw std::invalid_argument("batch replay needs --batch or --spec, one of the two");
  const BatchSpec spec = o.batch.empty() ? readBatchSpec(o.spec) : specOf(o.batch);
  if (o.run < 0 || (!o.batch.empty() && o.run >= spec.runs()))
    throw quad_support::ConfigError(
        fmt::format("run {}: must lie in 0..{}", o.run, spec.runs() - 1));
  const ExperimentConfig config = spec.experiment(o.run);
  quad_support::ResultDirectory results(o.out, o.force);
  InProcessPlant plant(config);
  const ExperimentResult result = runExperiment(config, {&plant}, "in_process", results);
  const std::string row = batchRow(
      spec, o.run, Json::parse(quad_support::readFile(results.workPath() + "/summary.json")));
  results.commit();
  quad_support::print(row, "the results stand in " + results.path());
  if (!o.batch.empty() && row != rowIn(o.batch + "/results.csv", o.run)) {
    throw quad_support::EnvironmentError(
        fmt::format("run {} differs from its row in {}/results.csv: another build or machine?",
                    o.run, o.batch));
  }
  tellResults("", results.path());
  return result.exitCode();
}
