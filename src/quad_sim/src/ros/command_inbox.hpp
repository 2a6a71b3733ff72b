/// Commands as they come in over a topic, by the stamp of the odometry they answer.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace quad_sim {

/// A command, or why it cannot be one.
struct ArrivedCommand {
  std::vector<double> rotor_speed;  ///< [rad/s]
  std::string problem;              ///< empty if it is fine
};

/// Filled by the topics' thread, emptied by the service's. Keeps the latest few stamps.
class CommandInbox {
 public:
  static constexpr double kLongestWait = 3600.0;  ///< [s]; the clock's nanoseconds end at 292 years

  void put(std::int64_t stamp_ns, ArrivedCommand command);
  /// Waits for the command of that stamp; nullopt after `timeout` [s] or when stop() was called.
  /// A timeout above kLongestWait is cut to it; one that is negative or no number does not wait.
  std::optional<ArrivedCommand> waitFor(std::int64_t stamp_ns, double timeout);
  /// The usable command that arrived last since clear(), if any.
  std::optional<ArrivedCommand> latest() const;
  void clear();
  void stop();  ///< wakes whoever waits, for good

 private:
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::map<std::int64_t, ArrivedCommand> by_stamp_;
  std::optional<ArrivedCommand> latest_;
  bool stopped_ = false;
};

}  // namespace quad_sim
