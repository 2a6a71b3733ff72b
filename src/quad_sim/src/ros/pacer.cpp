#include "pacer.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "quad_support/errors.hpp"

namespace quad_sim {

using Clock = std::chrono::steady_clock;

Pacer::Pacer(WorldGate& gate, double step, double real_time_factor, Run run)
    : gate_(gate),
      step_(step),
      real_time_factor_(real_time_factor),
      run_(std::move(run)),
      thread_([this] { loop(); }) {}

Pacer::~Pacer() {
  {
    const WorldGate::Visit visit(gate_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Pacer::setRunning(bool running) {
  running_ = running;
  changed_.notify_all();
}

/// Runs what is due since `since`, of which `done` steps are done already. Returns the steps done
/// then.
std::int64_t Pacer::runDue(Clock::time_point since, std::int64_t done) {
  // At most this much at a time, so that callers get in between: about 10 ms of simulated time.
  const std::int64_t most = std::max<std::int64_t>(1, std::llround(0.01 / step_));
  std::int64_t due = most;
  if (real_time_factor_ > 0) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - since).count();
    due = static_cast<std::int64_t>(elapsed * real_time_factor_ / step_) - done;
  }
  const std::int64_t steps = std::clamp<std::int64_t>(due, 0, most);
  run_(steps);
  return done + steps;
}

void Pacer::loop() {
  constexpr auto kNap = std::chrono::microseconds(500);  // half of the usual physics step
  std::unique_lock<std::mutex> lock(gate_.mutex());
  while (!stop_) {
    changed_.wait(lock, [this] { return running_ || stop_; });
    const auto since = Clock::now();
    std::int64_t done = 0;
    while (running_ && !stop_) {
      try {
        done = runDue(since, done);
      } catch (const quad_support::SimulationError& e) {
        ROS_FATAL("%s; paused", e.what());
        running_ = false;
      }
      lock.unlock();
      if (real_time_factor_ > 0) std::this_thread::sleep_for(kNap);
      while (gate_.wanted()) std::this_thread::yield();
      lock.lock();
    }
  }
}

}  // namespace quad_sim
