/// Runs the physics on a thread of its own while it is unpaused.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <thread>

#include "world_gate.hpp"

namespace quad_sim {

/// Calls run(steps) as often as the clock on the wall asks for, holding the gate, and opens the
/// gate in between.
class Pacer {
 public:
  using Run = std::function<void(std::int64_t steps)>;

  /// @param step  physics step [s]
  /// @param real_time_factor  simulated over wall time; 0: as fast as it goes
  /// @param run   moves the world; a SimulationError it throws is reported and pauses
  Pacer(WorldGate& gate, double step, double real_time_factor, Run run);
  ~Pacer();

  void setRate(double step, double real_time_factor);  ///< from within a visit
  double realTimeFactor() const { return real_time_factor_; }
  bool running() const {
    return running_;
  }                               ///< from any thread; certain only while visiting the gate
  void setRunning(bool running);  ///< from within a visit

 private:
  void loop();
  void runDue();

  WorldGate& gate_;
  double step_, real_time_factor_;
  Run run_;
  std::condition_variable changed_;
  std::atomic<bool> running_{false};  ///< changed under the gate only
  bool stop_ = false;
  std::int64_t done_ = 0;  ///< steps since since_
  std::chrono::steady_clock::time_point since_;
  std::thread thread_;
};

}  // namespace quad_sim
