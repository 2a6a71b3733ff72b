/// A process of the pool.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "chunk_queue.hpp"

namespace quad_experiment {

/// Starts this program again as a worker and speaks with it over two pipes. The worker dies with
/// this process, however that ends.
class WorkerProcess {
 public:
  /// @param arguments  after the program's name. @throws quad_support::EnvironmentError
  explicit WorkerProcess(const std::vector<std::string>& arguments);
  ~WorkerProcess();  ///< kills it if need be
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Hands it a chunk. A worker that has died meanwhile is seen by readLines().
  void give(const Chunk& chunk);
  const std::optional<Chunk>& chunk() const { return chunk_; }
  void finishChunk() { chunk_.reset(); }

  int descriptor() const { return from_; }  ///< for poll()
  /// The whole lines that have come. @param ended  set when the worker has closed its end
  std::vector<std::string> readLines(bool& ended);

  /// The run it says it flies; starts the clocks of spent().
  void beginRun(std::int64_t run);
  std::int64_t run() const { return run_; }
  double processorSeconds() const;  ///< used since beginRun()
  double wallSeconds() const;       ///< gone since beginRun()

  void askToStop();              ///< SIGTERM: it keeps what it has finished
  bool waitFor(double seconds);  ///< @returns whether it has ended
  void kill();

 private:
  double processorTime() const;

  pid_t pid_ = -1;
  int to_ = -1, from_ = -1;
  std::string buffer_;
  std::optional<Chunk> chunk_;
  std::int64_t run_ = -1;
  double processor_at_start_ = 0.0;
  std::chrono::steady_clock::time_point wall_at_start_;
};

}  // namespace quad_experiment
