#include "quad_control/control_config.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

using quad_support::ConfigReader;
using quad_support::Range;

PiGains readGains(const ConfigReader& control, const std::string& key) {
  const std::vector<double> gains = control.numbers(key, Range::nonNegative(), 4);
  return {gains[0], gains[1], gains[2], gains[3]};
}

// Decimal fractions such as 0.1 / 0.001 are whole only up to rounding; a step count is far from
// 1e9.
constexpr double kWholeTolerance = 1e-9;

// Far beyond any flight, near enough that a slip of the keyboard does not run for days.
constexpr double kLongestInterval = 60.0;  // [s]
constexpr double kLongestHold = 3600.0;    // [s]
constexpr double kMostSteps = 1e6, kMostIntervals = 1e6;

std::int64_t wholeSteps(const ConfigReader& timing, double period, double step) {
  const double steps = period / step;
  const double whole = std::round(steps);
  if (whole < 1.0 || std::abs(steps - whole) > kWholeTolerance * whole) {
    const double below = std::max(1.0, std::floor(steps));
    timing.fail("sampling_period",
                fmt::format("must be a whole number of simulation.step = {} s ({} s or {} s)", step,
                            below * step, (below + 1.0) * step));
  }
  if (whole > kMostSteps) {
    timing.fail("sampling_period", fmt::format("is {} physics steps of {} s; must be at most {}",
                                               whole, step, kMostSteps));
  }
  return static_cast<std::int64_t>(whole);
}

}  // namespace

const char* toString(TimingMode mode) {
  return mode == TimingMode::kLockstep ? "lockstep" : "wallclock";
}

TimingMode timingMode(const std::string& option, TimingMode otherwise) {
  for (const TimingMode mode : {TimingMode::kLockstep, TimingMode::kWallclock}) {
    if (option == toString(mode)) return mode;
  }
  if (option.empty()) return otherwise;
  throw quad_support::ConfigError(fmt::format("mode = {}; must be lockstep or wallclock", option));
}

ControlConfig readControlConfig(const ConfigReader& control, double sampling_period) {
  ControlConfig config;
  config.sampling_period = sampling_period;
  config.roll_pitch = readGains(control, "roll_pitch");
  config.yaw = readGains(control, "yaw");
  config.altitude = readGains(control, "altitude");
  config.position_loop = control.boolean("position_loop");
  config.hold_time = control.number("hold_time", Range::closed(0.0, kLongestHold, "s"));
  if (config.hold_time / sampling_period > kMostIntervals) {
    control.fail("hold_time",
                 fmt::format("must be at most {} intervals of timing.sampling_period = {} s",
                             kMostIntervals, sampling_period));
  }
  control.finish();
  return config;
}

TimingConfig readTimingConfig(const ConfigReader& timing, double step) {
  TimingConfig config;
  config.sampling_period =
      timing.number("sampling_period", Range{0.0, kLongestInterval, true, false, "s"});
  config.steps = wholeSteps(timing, config.sampling_period, step);
  config.mode = timingMode(timing.choice("mode", {"lockstep", "wallclock"}), config.mode);
  config.forgetting_factor = timing.number("forgetting_factor", Range::open(0.0, 1.0));
  config.latency = timing.number("latency", Range::nonNegative("s"));
  if (config.latency >= config.sampling_period) {
    timing.fail("latency",
                fmt::format("must be below sampling_period = {} s", config.sampling_period));
  }
  config.jitter_std = timing.number(
      "jitter_std",
      Range::closed(0.0, config.sampling_period, "s (timing.sampling_period at most)"));
  timing.finish();
  return config;
}

}  // namespace quad_control
