/// An inertial measurement unit: angular rate and specific force, with RotorS's noise parameters.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "quad_sim/state.hpp"
#include "quad_sim/vehicle_model.hpp"
#include "quad_support/random_stream.hpp"

namespace quad_sim {

/// One reading, axes of the sensor. Specific force is acceleration minus gravity: +g along z at
/// rest (REP 145).
struct ImuReading {
  std::int64_t time_ns = 0;
  Eigen::Quaterniond q_WS = Eigen::Quaterniond::Identity();  ///< true attitude: no IMU measures it
  Eigen::Vector3d rate_S = Eigen::Vector3d::Zero();          ///< [rad/s]
  Eigen::Vector3d specific_force_S = Eigen::Vector3d::Zero();  ///< [m/s²]
};

/// Noise of gyroscopes or accelerometers, the same for the three axes; [x] is rad/s or m/s².
struct InertialNoise {
  double density = 0;           ///< white noise [x/√Hz]
  double random_walk = 0;       ///< density of the bias's drive [x/s/√Hz]
  double correlation_time = 1;  ///< of the bias [s]
  double turn_on_sigma = 0;     ///< of the constant bias [x]
};

/// Adds the noise of an IMU to the truth.
///
/// Once a sample period P (1 / updateRate, or RotorS's 10 ms): white noise of density / √P; a
/// first-order Gauss-Markov bias b' = b exp(-P/tau) + sigma sqrt(tau/2 (1 - exp(-2P/tau))) n that
/// starts at 0; a constant turn-on bias. All of it is a function of (seed, sensor, sample): reading
/// seldom, twice or backwards changes nothing.
class ImuSensor {
 public:
  /// @param identity, seed, step  as for OdometrySensor
  /// @param compat  RotorS's ways: covariance of densities, tag gyroscopeRandomWalk not read
  /// @throws quad_support::ConfigError naming element and tag
  ImuSensor(const SensorModel& model, const std::string& identity, std::uint64_t seed, double step,
            bool compat);

  std::int64_t period() const { return period_; }  ///< physics steps from sample to sample
  /// `truth` in physics step `step`, as sensed with the noise of that step's sample.
  ImuReading sense(const ImuReading& truth, std::int64_t step);

  double rateVariance() const { return rate_.variance; }    ///< [rad²/s²]
  double forceVariance() const { return force_.variance; }  ///< [m²/s⁴]

 private:
  /// Three axes of gyroscopes or accelerometers.
  struct Triad {
    double white = 0, decay = 1, drive = 0, variance = 0;
    Eigen::Vector3d turn_on = Eigen::Vector3d::Zero(), bias = Eigen::Vector3d::Zero();
  };
  Triad triad(const InertialNoise& noise, double period, int first_draw, bool compat) const;
  void moveBiasesTo(std::int64_t sample);

  quad_support::RandomStream random_;
  std::int64_t period_;
  Triad rate_, force_;
  std::int64_t bias_sample_ = -1;  ///< the biases are those of this sample; -1: of none yet
};

/// Reads the noise of one triad. @param prefix "gyroscope" or "accelerometer"
InertialNoise readInertialNoise(const PluginDeclaration& declaration, const std::string& prefix,
                                bool compat);

}  // namespace quad_sim
