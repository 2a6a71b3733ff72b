#include "chunk_queue.hpp"

#include <algorithm>

namespace quad_experiment {

ChunkQueue::ChunkQueue(const std::vector<RunRange>& runs) {
  for (const RunRange range : runs) chunks_.push_back({range, 0});
}

std::int64_t ChunkQueue::size() const {
  std::int64_t count = 0;
  for (const Chunk& chunk : chunks_) count += chunk.runs.size();
  return count;
}

Chunk ChunkQueue::take(std::int64_t largest) {
  Chunk chunk = chunks_.front();
  chunks_.pop_front();
  const std::int64_t end = chunk.runs.first + std::max<std::int64_t>(largest, 1);
  if (chunk.deaths == 0 && end < chunk.runs.last) {
    chunks_.push_front({{end, chunk.runs.last}, 0});
    chunk.runs.last = end;
  }
  return chunk;
}

std::optional<std::int64_t> ChunkQueue::died(Chunk chunk) {
  if (++chunk.deaths < 2) {
    chunks_.push_front(chunk);
    return std::nullopt;
  }
  if (chunk.runs.size() == 1) return chunk.runs.first;
  const std::int64_t middle = chunk.runs.first + chunk.runs.size() / 2;
  giveBack({middle, chunk.runs.last}, 1);
  giveBack({chunk.runs.first, middle}, 1);
  return std::nullopt;
}

void ChunkQueue::giveBack(RunRange runs, int deaths) {
  if (runs.size() > 0) chunks_.push_front({runs, deaths});
}

}  // namespace quad_experiment
