#include "batch_progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace quad_experiment {
namespace {

std::string clockTime(double seconds) {
  const auto s = static_cast<long long>(seconds + 0.5);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

BatchProgress::BatchProgress(std::int64_t done_before, std::int64_t total)
    : terminal_(::isatty(STDERR_FILENO) != 0), before_(done_before), total_(total) {}

BatchProgress::~BatchProgress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void BatchProgress::show(std::int64_t done, int workers) {
  const auto now = Clock::now();
  if (!terminal_ || now - shown_ < std::chrono::milliseconds(200)) return;
  shown_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done - before_) / seconds;
  std::string line = fmt::format("\r\033[K{} of {} runs, {} workers", done, total_, workers);
  if (done > before_)
    line += fmt::format(", {:.1f} a second, {} left", rate,
                        clockTime(static_cast<double>(total_ - done) / rate));
  std::fputs(line.c_str(), stderr);
}

}  // namespace quad_experiment
