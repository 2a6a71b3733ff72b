/// The directory of a batch: its manifest, its finished chunks, the merged table.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "quad_experiment/batch_spec.hpp"

namespace quad_experiment {

/// Runs first … last - 1.
struct RunRange {
  std::int64_t first = 0, last = 0;
  std::int64_t size() const { return last - first; }
};

/// What may be in the way when a batch begins.
enum class IfBatchExists { kRefuse, kResume, kReplace };

/// `manifest.json` (hash of the spec, written first), `spec.yaml` and `settings.yaml` (copies),
/// `chunks/<first>-<last>.csv` (rows under a line with their checksum) and `results.csv`. Every
/// file is complete or absent; chunks may lie in any way over the runs, so any number of processes
/// may fill one directory.
class BatchStore {
 public:
  /// @throws std::invalid_argument  a batch is there already and kRefuse, or one of another spec,
  /// or something else
  /// @throws quad_support::EnvironmentError  the place cannot be written, or another process flies
  /// these runs
  /// @param lock  name of the part that only one process at a time may fill
  BatchStore(const BatchSpec& spec, const std::string& path, IfBatchExists exists,
             const std::string& lock);
  /// For a worker: the batch is there.
  BatchStore(const BatchSpec& spec, const std::string& path);
  BatchStore(const BatchStore&) = delete;
  BatchStore& operator=(const BatchStore&) = delete;

  /// @param rows  with their line ends
  void writeChunk(RunRange runs, const std::string& rows);

  /// What of `runs` no whole chunk holds. Damaged chunks are removed and named on stderr;
  /// beginnings that a killed process left are removed.
  std::vector<RunRange> missing(RunRange runs);

  /// Writes results.csv if every run is there. @returns whether it is
  bool merge();
  std::string resultsPath() const { return path_ + "/results.csv"; }
  const std::string& path() const { return path_; }

 private:
  void begin(IfBatchExists exists);
  /// Chunks by first run; of all, or only of those that touch `runs`.
  std::vector<RunRange> chunks(RunRange runs) const;
  std::string chunkPath(RunRange runs) const;
  /// The rows of a chunk, or nothing and what is wrong with it.
  bool readChunk(RunRange runs, std::string& rows, std::string& problem) const;
  void removeBeginnings(RunRange runs) const;

  const BatchSpec& spec_;
  std::string path_;
  std::shared_ptr<void> lock_;
};

}  // namespace quad_experiment
