#include <fmt/core.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <list>

#include "batch_progress.hpp"
#include "quad_experiment/batch.hpp"
#include "quad_experiment/batch_row.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"
#include "worker_process.hpp"

namespace quad_experiment {
namespace {

constexpr double kChunkSeconds = 4.0;    // lost at most when a worker is killed
constexpr std::int64_t kFirstChunk = 4;  // until a run's time is known
constexpr double kPatience = 10.0;       // [s] for a worker to write what it has finished
constexpr int kPollMilliseconds = 200;

/// The runs of one part, its workers, and who flies what.
class Pool {
 public:
  Pool(const BatchSpec& spec, const BatchOptions& options, BatchStore& store, RunRange runs)
      : spec_(spec),
        options_(options),
        store_(store),
        queue_(store.missing(runs)),
        total_(runs.size()),
        done_(total_ - queue_.size()),
        progress_(done_, total_) {}

  ~Pool() { stop(); }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  void run() {
    while (done_ < total_) {
      quad_support::throwIfInterrupted();
      employ();
      listen();
      endSlowRuns();
      progress_.show(done_ + in_flight_, static_cast<int>(workers_.size()));
    }
  }

 private:
  using Worker = std::list<WorkerProcess>::iterator;

  /// Starts workers while there is work for them, and hands out chunks.
  void employ() {
    for (auto& worker : workers_) {
      if (!worker.chunk() && !queue_.empty()) worker.give(queue_.take(chunkSize()));
    }
    while (!queue_.empty() && static_cast<int>(workers_.size()) < options_.workers) {
      workers_.emplace_back(std::vector<std::string>{
          "batch", "worker", "--spec", spec_.path, "--out", store_.path(), "--runs",
          fmt::format("{}", spec_.repeats), "--hash", spec_.hash});
      workers_.back().give(queue_.take(chunkSize()));
    }
  }

  std::int64_t chunkSize() const {
    if (options_.chunk > 0) return options_.chunk;
    if (seconds_per_run_ <= 0.0) return kFirstChunk;
    // Towards the end smaller, so that all workers end at about the same time.
    const std::int64_t share = queue_.size() / (2 * options_.workers) + 1;
    const auto size = static_cast<std::int64_t>(kChunkSeconds / seconds_per_run_);
    return std::clamp<std::int64_t>(size, 1, share);
  }

  void listen() {
    std::vector<pollfd> descriptors;
    for (const auto& worker : workers_) descriptors.push_back({worker.descriptor(), POLLIN, 0});
    if (::poll(descriptors.data(), descriptors.size(), kPollMilliseconds) < 0 && errno != EINTR)
      throw quad_support::EnvironmentError("cannot wait for the workers");
    std::size_t i = 0;
    for (auto worker = workers_.begin(); worker != workers_.end(); ++i) {
      const auto here = worker++;
      if (descriptors[i].revents != 0) hear(here);
    }
  }

  void hear(Worker worker) {
    bool ended = false;
    for (const std::string& line : worker->readLines(ended)) {
      if (line.rfind("run ", 0) == 0) {
        beginRun(*worker, std::stoll(line.substr(4)));
      } else if (line == "chunk") {
        finishChunk(*worker);
      } else if (line.rfind("fail ", 0) == 0) {
        throw quad_support::EnvironmentError(line.substr(5));
      }
    }
    if (ended) bury(worker);
  }

  void beginRun(WorkerProcess& worker, std::int64_t run) {
    timeLastRun(worker);
    if (worker.run() >= 0) ++in_flight_;
    worker.beginRun(run);
  }

  /// The mean over the last dozen runs or so sets the size of chunks; it touches no result.
  void timeLastRun(const WorkerProcess& worker) {
    if (worker.run() < 0) return;
    const double seconds = worker.wallSeconds();
    seconds_per_run_ += (seconds - seconds_per_run_) * (seconds_per_run_ > 0.0 ? 0.1 : 1.0);
  }

  void finishChunk(WorkerProcess& worker) {
    timeLastRun(worker);
    in_flight_ -= flown(worker);
    done_ += worker.chunk()->runs.size();
    worker.finishChunk();
  }

  /// Runs of its chunk that a worker has finished but not yet written.
  static std::int64_t flown(const WorkerProcess& worker) {
    return worker.chunk() && worker.run() >= 0 ? worker.run() - worker.chunk()->runs.first : 0;
  }

  /// A worker is gone: by a fault of its run, or killed from outside.
  void bury(Worker worker) {
    in_flight_ -= flown(*worker);
    const auto chunk = worker->chunk();
    const bool flew = chunk && worker->run() >= 0;
    workers_.erase(worker);
    if (!flew) {  // no run's fault: the program or its spec is gone, or nobody lets it start
      if (chunk) queue_.giveBack(chunk->runs, chunk->deaths);
      if (++idle_deaths_ > kMaxIdleDeaths)
        throw quad_support::EnvironmentError("workers end before they fly anything");
      return;
    }
    if (const auto poison = queue_.died(*chunk)) record(*poison, RunStatus::kCrashed);
  }

  /// A row for a run that no worker lived to write.
  void record(std::int64_t run, RunStatus status) {
    store_.writeChunk({run, run + 1}, batchRow(spec_, run, status));
    ++done_;
  }

  void endSlowRuns() {
    for (auto worker = workers_.begin(); worker != workers_.end();) {
      const auto here = worker++;
      const bool slow = here->processorSeconds() > options_.timeout ||
                        here->wallSeconds() > 10.0 * options_.timeout;
      if (!here->chunk() || !slow) continue;
      const Chunk chunk = *here->chunk();
      const std::int64_t run = here->run();
      in_flight_ -= flown(*here);
      workers_.erase(here);
      queue_.giveBack({run + 1, chunk.runs.last}, chunk.deaths);
      queue_.giveBack({chunk.runs.first, run}, chunk.deaths);
      record(run, RunStatus::kTimeout);
    }
  }

  /// Ends all workers; each first writes the runs it has finished.
  void stop() {
    for (auto& worker : workers_) worker.askToStop();
    for (auto& worker : workers_) worker.waitFor(kPatience);
    workers_.clear();  // kills what is left
  }

  static constexpr int kMaxIdleDeaths = 5;

  const BatchSpec& spec_;
  const BatchOptions& options_;
  BatchStore& store_;
  ChunkQueue queue_;
  std::int64_t total_, done_, in_flight_ = 0;
  std::list<WorkerProcess> workers_;
  double seconds_per_run_ = 0.0;
  int idle_deaths_ = 0;
  BatchProgress progress_;
};

}  // namespace

RunRange shardRuns(std::int64_t runs, int shard, int shards) {
  return {runs * (shard - 1) / shards, runs * shard / shards};
}

bool runBatch(const BatchSpec& spec, const BatchOptions& options) {
  const std::string lock =
      options.shards > 1 ? fmt::format("-{}-of-{}", options.shard, options.shards) : "";
  BatchStore store(spec, options.out, options.exists, lock);
  const RunRange runs = shardRuns(spec.runs(), options.shard, options.shards);
  if (runs.size() > 0) Pool(spec, options, store, runs).run();
  return store.merge();
}

}  // namespace quad_experiment
