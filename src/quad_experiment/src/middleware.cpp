#include "quad_experiment/middleware.hpp"

#include <algorithm>
#include <cmath>

#include "quad_experiment/streams.hpp"
#include "quad_support/random_stream.hpp"

namespace quad_experiment {

Middleware::Middleware(const MiddlewareConfig& config, std::uint64_t seed, std::uint64_t flight)
    : period_steps_(std::round(config.sampling_period / config.step)),
      jitter_steps_(config.jitter_std / config.step),
      latency_steps_(static_cast<int>(std::lround(config.latency / config.step))),
      seed_(seed),
      flight_(flight) {}

Interval Middleware::interval(std::uint64_t index) const {
  double steps = period_steps_;
  if (jitter_steps_ > 0.0) {
    const quad_support::RandomStream random(seed_, 0, kJitterStream + flight_);
    steps = std::round(period_steps_ + jitter_steps_ * random.normal(index));
  }
  return {std::max(latency_steps_ + 1, static_cast<int>(steps)), latency_steps_};
}

std::int64_t Middleware::totalSteps(std::uint64_t count) const {
  std::int64_t total = 0;
  for (std::uint64_t i = 0; i < count; ++i) total += interval(i).steps;
  return total;
}

}  // namespace quad_experiment
