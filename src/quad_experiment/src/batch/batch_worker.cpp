#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>

#include "quad_experiment/batch.hpp"
#include "quad_experiment/batch_row.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"

namespace quad_experiment {
namespace {

/// A line from the pool; false at the end. A signal while waiting is an interruption.
bool readLine(std::string& line) {
  line.clear();
  for (char c = 0;;) {
    quad_support::throwIfInterrupted();
    const ssize_t n = ::read(STDIN_FILENO, &c, 1);
    if (n == 0 || (n < 0 && errno != EINTR)) return false;
    if (n < 0) continue;
    if (c == '\n') return true;
    line += c;
  }
}

/// Nobody listens any more: there is nothing to work for, and no one to tell.
void tell(const std::string& line) {
  if (::write(STDOUT_FILENO, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    throw quad_support::EnvironmentError("the pool that started this worker is gone");
}

void flyChunk(const BatchSpec& spec, RunRange runs, BatchStore& store, DesignMemory& designs) {
  std::string rows;
  for (std::int64_t run = runs.first; run < runs.last; ++run) {
    tell(fmt::format("run {}\n", run));
    try {
      rows += flyBatchRun(spec, run, designs);
    } catch (const quad_support::Interrupted&) {
      if (run > runs.first) store.writeChunk({runs.first, run}, rows);  // nothing finished is lost
      throw;
    }
  }
  store.writeChunk(runs, rows);
  tell("chunk\n");
}

}  // namespace

int serveBatch(const BatchSpec& spec, const std::string& out) {
  BatchStore store(spec, out);
  DesignMemory designs;
  try {
    for (std::string line; readLine(line);) {
      long long first = 0, last = 0;
      if (std::sscanf(line.c_str(), "%lld %lld", &first, &last) != 2 || first < 0 ||
          last <= first || last > spec.runs())
        throw std::invalid_argument("not a range of runs: '" + line + "'");
      flyChunk(spec, {first, last}, store, designs);
    }
  } catch (const std::bad_alloc&) {
    std::fputs("a worker ran out of memory\n", stderr);
    return quad_support::kEnvironment;  // a death, so that the run that asks for too much is found
  } catch (const quad_support::Interrupted& e) {
    return 128 + e.signal();  // the pool says so
  } catch (const std::exception& e) {
    tell(fmt::format("fail {}\n", e.what()));
    return quad_support::kEnvironment;
  }
  return quad_support::kDone;
}

}  // namespace quad_experiment
