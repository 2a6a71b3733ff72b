#include "answer_limit.hpp"

namespace quad_experiment {

AnswerLimit::AnswerLimit() : thread_([this] { watch(); }) {}

AnswerLimit::~AnswerLimit() {
  stop_ = true;
  thread_.join();
}

void AnswerLimit::begin(ros::ServiceClient& client, double seconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = &client;
  cut_ = false;
  deadline_ = Clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool AnswerLimit::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = nullptr;
  return cut_;
}

void AnswerLimit::watch() {
  constexpr auto kLookEvery = std::chrono::milliseconds(20);
  while (!stop_) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (client_ && !cut_ && Clock::now() > deadline_) {
        cut_ = true;
        client_->shutdown();
      }
    }
    std::this_thread::sleep_for(kLookEvery);
  }
}

}  // namespace quad_experiment
