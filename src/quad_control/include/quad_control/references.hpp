/// Where a vehicle shall be, and when: references that change at set times, and the samples a
/// controller answers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quad_control/flight_controller.hpp"

namespace quad_control {

/// References from a time on.
struct Waypoint {
  std::int64_t from_start_ns = 0;
  References references;
};

/// A list of waypoints, each in force from its time on. Time begins with the first call of at().
class ReferenceTrajectory {
 public:
  /// @throws quad_support::ConfigError for an empty list, a figure that is not finite, times that
  /// are negative or fall
  explicit ReferenceTrajectory(std::vector<Waypoint> waypoints);

  /// The references in force at `time_ns` of simulated time; nullopt before the first waypoint's. A
  /// time before the start means that the simulation was reset: the trajectory starts again.
  std::optional<References> at(std::int64_t time_ns);
  bool isFinished(std::int64_t time_ns) const;  ///< whether the last waypoint is in force

 private:
  std::vector<Waypoint> waypoints_;
  std::optional<std::int64_t> start_ns_;
};

/// A text with a waypoint a line: seconds after the one before, x, y, z [m], yaw [degrees];
/// RotorS's format. Empty lines and what follows a # are comments. @throws
/// quad_support::ConfigError with name:line
std::vector<Waypoint> readWaypoints(const std::string& text, const std::string& name);

/// Picks, from odometry that comes as fast as it likes, the samples that are a sampling period
/// apart, which is what the integrals of a PI controller count on. To half an odometry interval;
/// odometry slower than the period is taken as it comes.
class SampleClock {
 public:
  explicit SampleClock(double period) : period_ns_(period * 1e9) {}
  /// To be asked for each odometry, in order. Time that goes back begins anew with a sample.
  bool isSample(std::int64_t time_ns);

 private:
  double period_ns_;
  std::optional<std::int64_t> last_sample_ns_, last_ns_;
};

}  // namespace quad_control
