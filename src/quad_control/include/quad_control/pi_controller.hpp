/// The PI law of thesis section 2.2, one instance an axis.
#pragma once

namespace quad_control {

/// The four gains of thesis section 2.2. "position" is an angle [rad] or the altitude [m],
/// "velocity" its derivative; the output is a torque [N m] or a force [N].
struct PiGains {
  double position = 0.0;           ///< K_P^p [N m/rad | N/m]
  double position_integral = 0.0;  ///< K_I^p [N m/(rad s) | N/(m s)]
  double velocity = 0.0;           ///< K_P^v [N m s/rad | N s/m]
  double velocity_integral = 0.0;  ///< K_I^v [N m/rad | N/m]
};

/// Where the output saturates; min <= max.
struct OutputLimits {
  double min = 0.0;
  double max = 0.0;
};

/// u[k] = K_P^p e_P^p[k] + K_I^p e_I^p[k] + K_P^v e_P^v[k] + K_I^v e_I^v[k], with e_I[k] = e_I0 +
/// Σ_{i=1..k} e_P[i] dT (thesis section 2.2), clamped to the limits.
///
/// The first call after reset() is k = 0, so it answers with e_I0 alone. Anti-windup: an integral
/// whose error pushes the output further beyond the limit it has passed is not advanced; one that
/// leads back is.
class PiController {
 public:
  /// @param sampling_period  dT [s] of the sum; > 0
  /// @throws std::invalid_argument if a gain is negative or not finite, dT is not positive, or min
  /// > max
  PiController(const PiGains& gains, double sampling_period, const OutputLimits& limits);

  /// Starts again at k = 0 with the integral part of the output at `initial_effort` [N m | N]: e_I0
  /// = effort / K_I, in the position's integral, or in the velocity's where K_I^p = 0.
  /// @throws quad_support::ConfigError if `initial_effort` is not zero and there is no integral
  /// gain to hold it
  void reset(double initial_effort = 0.0);

  /// The output for the errors reference − measurement of sample k, then k + 1.
  double update(double position_error, double velocity_error);

  bool saturated() const { return saturated_; }  ///< whether the last output was clamped
  double positionIntegral() const {
    return position_sum_;
  }  ///< e_I^p of the last output [rad s | m s]
  double velocityIntegral() const { return velocity_sum_; }  ///< e_I^v of the last output [rad | m]

 private:
  PiGains gains_;
  double sampling_period_;
  OutputLimits limits_;
  double position_sum_ = 0.0, velocity_sum_ = 0.0;
  bool first_ = true, saturated_ = false;
};

}  // namespace quad_control
