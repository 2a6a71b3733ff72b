/// Many experiments by a pool of processes, with the same table at the end whatever happened on the
/// way.
#pragma once

#include <string>

#include "quad_experiment/batch_spec.hpp"
#include "quad_experiment/batch_store.hpp"

namespace quad_experiment {

struct BatchOptions {
  std::string out;  ///< directory of the batch
  IfBatchExists exists = IfBatchExists::kRefuse;
  int workers = 1;            ///< processes
  std::int64_t chunk = 0;     ///< runs a chunk; 0: so many that it takes seconds
  double timeout = 300.0;     ///< [s] of a run's processor time (ten times as long by the clock)
  int shard = 1, shards = 1;  ///< this process flies the shard-th of so many equal parts
};

/// The runs of one part.
RunRange shardRuns(std::int64_t runs, int shard, int shards);

/// Flies what is missing of a part and merges if that was the last. Ends all workers, whatever
/// happens.
/// @returns whether results.csv is there
/// @throws what BatchStore throws; quad_support::EnvironmentError: a worker cannot be started or
/// cannot write;
///         quad_support::Interrupted: finished runs are kept
bool runBatch(const BatchSpec& spec, const BatchOptions& options);

/// The worker's side: reads "first last" lines from standard input until its end, flies these runs,
/// writes the chunk. On standard output: "run r" before each run, "chunk" when it is written, "fail
/// …" before it gives up.
int serveBatch(const BatchSpec& spec, const std::string& out);

/// What results.csv says, in a dozen lines: how runs ended, quantiles of what matters, whether
/// gamma_w held.
std::string batchDigest(const std::string& results_csv);

}  // namespace quad_experiment
