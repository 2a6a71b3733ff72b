/// Bounds the time a service may take. roscpp itself waits for ever for a node that hangs.
#pragma once

#include <ros/service_client.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace quad_experiment {

/// Watches one call at a time from a thread of its own, which looks every few milliseconds: a
/// flight makes thousands of calls, and waking somebody for each would slow it down.
class AnswerLimit {
 public:
  AnswerLimit();
  ~AnswerLimit();
  AnswerLimit(const AnswerLimit&) = delete;
  AnswerLimit& operator=(const AnswerLimit&) = delete;

  /// Calls the service. When there is no answer after `seconds` of wall time the connection is cut,
  /// which ends the call. @returns the call's success; `late` says whether the limit was why not
  template <class Service>
  bool call(ros::ServiceClient& client, Service& service, double seconds, bool& late) {
    begin(client, seconds);
    const bool answered = client.call(service);
    late = end();
    return answered;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void begin(ros::ServiceClient& client, double seconds);
  bool end();
  void watch();

  std::mutex mutex_;  ///< of the three below
  ros::ServiceClient* client_ = nullptr;
  Clock::time_point deadline_;
  bool cut_ = false;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace quad_experiment
