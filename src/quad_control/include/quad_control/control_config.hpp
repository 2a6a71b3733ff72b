/// Settings of the controllers and of the time management: the sections `control:` and `timing:` of
/// a config file.
#pragma once

#include <cstdint>
#include <string>

#include "quad_control/pi_controller.hpp"
#include "quad_support/config_reader.hpp"

namespace quad_control {

/// Section `control:`. The gains shipped in config/thesis.yaml are derived in
/// docs/design/0002-control-gains.md.
struct ControlConfig {
  double sampling_period = 0.0;  ///< dT of the integrals [s]; timing.sampling_period; > 0
  PiGains roll_pitch;            ///< [N m/rad, N m/(rad s), N m s/rad, N m/rad]
  PiGains yaw;                   ///< the same units
  PiGains altitude;              ///< [N/m, N/(m s), N s/m, N/m]
  bool position_loop = false;    ///< outer loop of thesis Fig. 1.2, in the hold
  double hold_time = 0.0;        ///< PI hold before exploration [s]; >= 0
};

enum class TimingMode { kLockstep, kWallclock };
const char* toString(TimingMode mode);
/// @param option  lockstep, wallclock, or empty for `otherwise`. @throws quad_support::ConfigError
/// for another word
TimingMode timingMode(const std::string& option, TimingMode otherwise);

/// Section `timing:`.
struct TimingConfig {
  double sampling_period = 0.0;  ///< dT [s]; a whole number of physics steps
  std::int64_t steps = 0;        ///< dT in physics steps; >= 1
  TimingMode mode = TimingMode::kLockstep;
  double forgetting_factor = 0.0;  ///< λ of thesis 1.2.4; in (0, 1)
  double latency =
      0.0;  ///< from state sample to effective command [s]; >= 0, below sampling_period
  double jitter_std = 0.0;  ///< standard deviation of the interval's length [s]; >= 0
};

/// Reads section `control:` (every key required) and complains about unknown keys.
/// @param sampling_period  timing.sampling_period [s]
/// @throws quad_support::ConfigError with file, line, key, value and limit
ControlConfig readControlConfig(const quad_support::ConfigReader& control, double sampling_period);

/// Reads section `timing:` (every key required) and complains about unknown keys.
/// @param step  simulation.step [s]
/// @throws quad_support::ConfigError with file, line, key, value and limit
TimingConfig readTimingConfig(const quad_support::ConfigReader& timing, double step);

}  // namespace quad_control
