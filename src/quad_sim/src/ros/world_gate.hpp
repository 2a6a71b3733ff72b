/// Who may touch the world: one at a time, and callers before the running loop.
#pragma once

#include <atomic>
#include <mutex>

namespace quad_sim {

/// A mutex whose waiting callers can be seen, so that a loop that holds it most of the time lets
/// them in between steps.
class WorldGate {
 public:
  /// Holds the world from construction to destruction.
  class Visit {
   public:
    explicit Visit(WorldGate& gate) : gate_(gate), lock_(gate.mutex_, std::defer_lock) {
      ++gate_.waiting_;
      lock_.lock();
    }
    ~Visit() { --gate_.waiting_; }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    WorldGate& gate_;
    std::unique_lock<std::mutex> lock_;
  };

  bool wanted() const { return waiting_.load() > 0; }  ///< somebody visits or waits to
  std::mutex& mutex() { return mutex_; }               ///< for the running loop alone

 private:
  std::mutex mutex_;
  std::atomic<int> waiting_{0};
};

}  // namespace quad_sim
