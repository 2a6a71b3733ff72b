#include "pushes.hpp"

#include <algorithm>
#include <stdexcept>

#include "odometry_topics.hpp"

namespace quad_sim {

void Pushes::add(const Push& push) {
  if (!push.wrench.force.allFinite() || !push.wrench.torque.allFinite()) {
    throw std::invalid_argument("every number of the wrench must be finite");
  }
  pushes_.push_back(push);
  apply();
}

void Pushes::clear() {
  pushes_.clear();
  simulator_.setPush({});
}

std::int64_t Pushes::nextEvent() const {
  const std::int64_t now = simulator_.timeNanoseconds(), step = simulator_.stepNanoseconds();
  std::int64_t next = OdometryTopics::kNever;
  for (const Push& push : pushes_) {
    const std::int64_t time = push.start_ns > now ? push.start_ns : push.end_ns;
    next = std::min(next, (time + step - 1) / step);
  }
  return next;
}

void Pushes::apply() {
  if (pushes_.empty()) return;
  const std::int64_t now = simulator_.timeNanoseconds();
  const auto over = [now](const Push& push) { return push.end_ns <= now; };
  pushes_.erase(std::remove_if(pushes_.begin(), pushes_.end(), over), pushes_.end());
  Wrench sum;
  for (const Push& push : pushes_) {
    if (push.start_ns > now) continue;
    sum.force += push.wrench.force;
    sum.torque += push.wrench.torque;
  }
  simulator_.setPush(sum);
}

void Pushes::archive(StateArchive& archive) {
  std::int64_t count = static_cast<std::int64_t>(pushes_.size());
  archive(count);
  constexpr std::int64_t kMost = 1000000;  // a saved state that says more is damaged
  if (count < 0 || count > kMost) throw std::out_of_range("saved state: number of pushes");
  pushes_.resize(static_cast<std::size_t>(count));
  for (Push& push : pushes_) {
    archive(push.wrench.force);
    archive(push.wrench.torque);
    archive(push.start_ns);
    archive(push.end_ns);
  }
}

}  // namespace quad_sim
