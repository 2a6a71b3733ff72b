#include "quad_control/pi_controller.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "quad_support/errors.hpp"

namespace quad_control {

PiController::PiController(const PiGains& gains, double sampling_period, const OutputLimits& limits)
    : gains_(gains), sampling_period_(sampling_period), limits_(limits) {
  for (const double gain :
       {gains.position, gains.position_integral, gains.velocity, gains.velocity_integral}) {
    if (!(gain >= 0.0 && std::isfinite(gain))) {
      throw std::invalid_argument(
          fmt::format("PI controller: gain = {}; must be finite and >= 0", gain));
    }
  }
  if (!(sampling_period > 0.0 && std::isfinite(sampling_period))) {
    throw std::invalid_argument(
        fmt::format("PI controller: sampling period = {} s; must be > 0 s", sampling_period));
  }
  if (!(limits.min <= limits.max)) {
    throw std::invalid_argument(
        fmt::format("PI controller: output limits [{}, {}] are empty", limits.min, limits.max));
  }
}

void PiController::reset(double initial_effort) {
  position_sum_ = velocity_sum_ = 0.0;
  first_ = true;
  saturated_ = false;
  if (initial_effort == 0.0) return;
  if (gains_.position_integral > 0.0) {
    position_sum_ = initial_effort / gains_.position_integral;
  } else if (gains_.velocity_integral > 0.0) {
    velocity_sum_ = initial_effort / gains_.velocity_integral;
  } else {
    throw quad_support::ConfigError(
        fmt::format("control: an integral that starts at {} N needs an integral gain; K_I^p and "
                    "K_I^v are both 0",
                    initial_effort));
  }
}

double PiController::update(double position_error, double velocity_error) {
  // The sum of section 2.2 starts at i = 1: sample 0 sees e_I0 alone.
  const double period = first_ ? 0.0 : sampling_period_;
  first_ = false;
  const auto output = [&](double position_sum, double velocity_sum) {
    return gains_.position * position_error + gains_.position_integral * position_sum +
           gains_.velocity * velocity_error + gains_.velocity_integral * velocity_sum;
  };
  const double next_position_sum = position_sum_ + position_error * period;
  const double next_velocity_sum = velocity_sum_ + velocity_error * period;
  const double wanted = output(next_position_sum, next_velocity_sum);
  const int beyond = wanted > limits_.max ? 1 : (wanted < limits_.min ? -1 : 0);
  if (beyond * position_error <= 0.0) position_sum_ = next_position_sum;
  if (beyond * velocity_error <= 0.0) velocity_sum_ = next_velocity_sum;
  const double given = output(position_sum_, velocity_sum_);
  saturated_ = given < limits_.min || given > limits_.max;
  return std::clamp(given, limits_.min, limits_.max);
}

}  // namespace quad_control
