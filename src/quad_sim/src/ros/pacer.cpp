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

void Pacer::setRate(double step, double real_time_factor) {
  step_ = step;
  real_time_factor_ = real_time_factor;
  since_ = Clock::now();
  done_ = 0;
}

namespace {

/// Steps that the wall clock asks for since `since`.
std::int64_t stepsSince(Clock::time_point since, double real_time_factor, double step) {
  const double elapsed = std::chrono::duration<double>(Clock::now() - since).count();
  return static_cast<std::int64_t>(elapsed * real_time_factor / step);
}

}  // namespace

/// Runs what is due since `since_`, of which `done_` steps are done already.
void Pacer::runDue() {
  // At most this much at a time, so that callers get in between: about 10 ms of simulated time.
  const std::int64_t most = std::max<std::int64_t>(1, std::llround(0.01 / step_));
  std::int64_t due = most;
  if (real_time_factor_ > 0) due = stepsSince(since_, real_time_factor_, step_) - done_;
  const std::int64_t steps = std::clamp<std::int64_t>(due, 0, most);
  run_(steps);
  done_ += steps;
}

void Pacer::loop() {
  constexpr auto kNap = std::chrono::microseconds(500);  // half of the usual physics step
  std::unique_lock<std::mutex> lock(gate_.mutex());
  while (!stop_) {
    changed_.wait(lock, [this] { return running_ || stop_; });
    since_ = Clock::now();
    done_ = 0;
    while (running_ && !stop_) {
      try {
        runDue();
      } catch (const quad_support::SimulationError& e) {
        ROS_FATAL("%s; paused", e.what());
        running_ = false;
      }
      const bool nap = real_time_factor_ > 0 &&
                       stepsSince(since_, real_time_factor_, step_) <= done_;  // nothing is due yet
      lock.unlock();
      if (nap) std::this_thread::sleep_for(kNap);
      while (gate_.wanted()) std::this_thread::yield();
      lock.lock();
    }
  }
}

}  // namespace quad_sim
