/// The simulated middleware: how long each control interval really lasts and how late its command
/// acts.
#pragma once

#include <cstdint>

namespace quad_experiment {

/// One control interval in whole physics steps: first `hold_steps` with the previous command
/// (latency), then the rest of `steps` with the new one.
struct Interval {
  int steps = 0;
  int hold_steps = 0;
};

/// Settings of the middleware, in seconds as configured and in whole physics steps as flown.
struct MiddlewareConfig {
  double sampling_period = 0.0;  ///< dT [s]
  double latency = 0.0;          ///< [s] from state sample to effective command
  double jitter_std = 0.0;       ///< [s] of an interval's length, Gaussian
  double step = 0.0;             ///< physics step [s]
};

/// A seeded model of latency and jitter: interval k lasts max(latency + 1, round(dT + jitter n_k))
/// steps with n_k standard normal. Any interval can be asked for alone and is always the same.
class Middleware {
 public:
  /// @param seed, flight  address the random stream; each flight of an experiment has its own
  Middleware(const MiddlewareConfig& config, std::uint64_t seed, std::uint64_t flight);

  /// @param index  of the interval since the flight's start (hold phase included)
  Interval interval(std::uint64_t index) const;

  /// Steps of the first `count` intervals together.
  std::int64_t totalSteps(std::uint64_t count) const;

 private:
  double period_steps_, jitter_steps_;
  int latency_steps_;
  std::uint64_t seed_, flight_;
};

}  // namespace quad_experiment
