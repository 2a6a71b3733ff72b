/// Odometry as a sensor delivers it: noisy, seldom, late. Tags are those of RotorS's odometry
/// plugin.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "quad_sim/state.hpp"
#include "quad_sim/state_archive.hpp"
#include "quad_sim/vehicle_model.hpp"
#include "quad_support/random_stream.hpp"

namespace quad_sim {

/// Noise of one three-component quantity: the sum of a normal and a uniform part, each axis by
/// itself.
struct VectorNoise {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< standard deviation
  Eigen::Vector3d uniform = Eigen::Vector3d::Zero();  ///< bound: within [-u, u]
};

/// One odometry sensor.
///
/// Times are counted in cycles: 10 ms, RotorS's physics step, or 1 / updateRate (our tag). The
/// noise of a reading is a function of (seed, sensor, physics step) alone, whoever else reads, how
/// often and in what order.
class OdometrySensor {
 public:
  /// @param identity  what the sensor is called in the world, "bee1/odometry_sensor1/odometry":
  /// picks its noise
  /// @param seed      of the world; the tag randomEngineSeed takes precedence
  /// @param step      physics step [s]
  /// @param compat    RotorS's ways: covariance without the uniform part, unknownDelay cut to whole
  /// seconds
  /// @throws quad_support::ConfigError naming element and tag
  OdometrySensor(const SensorModel& model, const std::string& identity, std::uint64_t seed,
                 double step, bool compat);

  bool scheduled() const {
    return period_ > 0;
  }  ///< has instants of its own; otherwise senses whenever asked
  std::int64_t period() const { return period_; }  ///< steps from sample to sample
  std::int64_t delay() const { return delay_; }    ///< steps from sample to delivery
  std::int64_t extraStamp() const {
    return extra_stamp_ns_;
  }  ///< [ns] added to stamps: unknownDelay

  /// `truth` of the sensor's frame in physics step `step`, as sensed. Without noise, the very bits
  /// of it.
  Odometry sense(const Odometry& truth, std::int64_t step) const;

  /// Variances of position [m²] and attitude [rad²]; of velocity [m²/s²] and rate [rad²/s²].
  const std::array<double, 6>& poseVariance() const { return pose_variance_; }
  const std::array<double, 6>& twistVariance() const { return twist_variance_; }

 private:
  Eigen::Vector3d draw(const VectorNoise& noise, std::int64_t step, int quantity) const;

  quad_support::RandomStream random_;
  std::array<VectorNoise, 4> noise_;  ///< position, attitude, velocity, rate
  bool noisy_ = false;
  std::int64_t period_ = 0, delay_ = 0, extra_stamp_ns_ = 0;
  std::array<double, 6> pose_variance_{}, twist_variance_{};
};

/// Samples on their way out of a scheduled sensor.
class OdometryDelay {
 public:
  explicit OdometryDelay(const OdometrySensor& sensor) : sensor_(sensor) {}

  /// The first step after `step` at which something is sampled or delivered.
  std::int64_t nextEvent(std::int64_t step) const;
  /// To be called at each event, with the truth then. What comes out of the sensor at this step, if
  /// anything does.
  std::optional<Odometry> at(std::int64_t step, const Odometry& truth);
  void clear() { waiting_.clear(); }
  void archive(StateArchive& archive);

 private:
  struct Sample {
    std::int64_t due = 0;  ///< step
    Odometry odometry;
  };
  const OdometrySensor& sensor_;
  std::deque<Sample> waiting_;
};

/// A sensor's random stream, from its name, so that other sensors and vehicles do not move it.
quad_support::RandomStream sensorStream(std::uint64_t seed, const std::string& identity);

/// A sensor's cycle in physics steps: the tag updateRate [Hz], or RotorS's 10 ms; at least one
/// step.
std::int64_t sensorCycle(const PluginDeclaration& declaration, double step);

/// The number in a tag that must be >= 0. @throws quad_support::ConfigError
double nonNegative(const PluginDeclaration& declaration, const std::string& tag, double fallback);

}  // namespace quad_sim
