/// How far a batch is, for whoever watches a terminal.
#pragma once

#include <chrono>
#include <cstdint>

namespace quad_experiment {

/// One line on stderr, written over at most five times a second: runs done, runs a second, time
/// left. Silent when stderr is no terminal.
class BatchProgress {
 public:
  BatchProgress(std::int64_t done_before, std::int64_t total);
  ~BatchProgress();  ///< takes the line away
  BatchProgress(const BatchProgress&) = delete;
  BatchProgress& operator=(const BatchProgress&) = delete;
  void show(std::int64_t done, int workers);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  std::int64_t before_, total_;
  Clock::time_point start_ = Clock::now(), shown_;
};

}  // namespace quad_experiment
