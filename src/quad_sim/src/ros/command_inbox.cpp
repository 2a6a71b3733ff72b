#include "command_inbox.hpp"

#include <algorithm>
#include <chrono>

namespace quad_sim {

void CommandInbox::put(std::int64_t stamp_ns, ArrivedCommand command) {
  constexpr std::size_t kKept =
      64;  // a controller is at most a few intervals ahead of or behind the simulator
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (command.problem.empty()) latest_ = command;
    by_stamp_[stamp_ns] = std::move(command);
    if (by_stamp_.size() > kKept) by_stamp_.erase(by_stamp_.begin());
  }
  arrived_.notify_all();
}

std::optional<ArrivedCommand> CommandInbox::waitFor(std::int64_t stamp_ns, double timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto here = [&] { return stopped_ || by_stamp_.count(stamp_ns) > 0; };
  const double wait = timeout > 0 ? std::min(timeout, kLongestWait) : 0.0;
  const auto limit = std::chrono::steady_clock::now() + std::chrono::duration<double>(wait);
  if (!arrived_.wait_until(lock, limit, here) || stopped_) return std::nullopt;
  return by_stamp_.at(stamp_ns);
}

std::optional<ArrivedCommand> CommandInbox::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return latest_;
}

void CommandInbox::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  by_stamp_.clear();
  latest_.reset();
}

void CommandInbox::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
  }
  arrived_.notify_all();
}

}  // namespace quad_sim
