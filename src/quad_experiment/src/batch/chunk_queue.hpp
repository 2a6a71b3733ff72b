/// The runs still to be flown, handed out in pieces.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "quad_experiment/batch_store.hpp"

namespace quad_experiment {

/// Consecutive runs for one worker.
struct Chunk {
  RunRange runs;
  int deaths = 0;  ///< of workers that flew it
};

/// A chunk whose worker dies is flown once more. When it dies twice it is halved, until the run
/// that does it is alone.
class ChunkQueue {
 public:
  explicit ChunkQueue(const std::vector<RunRange>& runs);

  bool empty() const { return chunks_.empty(); }
  std::int64_t size() const;  ///< runs waiting

  /// At most `largest` runs; what died before comes whole. Not when empty.
  Chunk take(std::int64_t largest);
  /// Its worker ended before it was done. @returns the run, if it was alone and for the second time
  std::optional<std::int64_t> died(Chunk chunk);
  /// Runs of a chunk that shall be flown again through no fault of theirs; an empty range is
  /// nothing.
  void giveBack(RunRange runs, int deaths);

 private:
  std::deque<Chunk> chunks_;
};

}  // namespace quad_experiment
