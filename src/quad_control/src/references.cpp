#include "quad_control/references.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_control {

using quad_support::ConfigError;

ReferenceTrajectory::ReferenceTrajectory(std::vector<Waypoint> waypoints)
    : waypoints_(std::move(waypoints)) {
  if (waypoints_.empty()) throw ConfigError("trajectory: no waypoint");
  std::int64_t before = 0;
  for (std::size_t i = 0; i < waypoints_.size(); ++i) {
    const References& r = waypoints_[i].references;
    for (const double value : {r.x, r.y, r.z, r.yaw}) {
      if (!std::isfinite(value))
        throw ConfigError(fmt::format("trajectory: waypoint {}: {} is not finite", i, value));
    }
    if (waypoints_[i].from_start_ns < before) {
      throw ConfigError(fmt::format("trajectory: waypoint {}: time {} s; must be >= {} s", i,
                                    1e-9 * static_cast<double>(waypoints_[i].from_start_ns),
                                    1e-9 * static_cast<double>(before)));
    }
    before = waypoints_[i].from_start_ns;
  }
}

std::optional<References> ReferenceTrajectory::at(std::int64_t time_ns) {
  if (!start_ns_ || time_ns < *start_ns_) start_ns_ = time_ns;
  std::optional<References> now;
  for (const Waypoint& waypoint : waypoints_) {
    if (waypoint.from_start_ns > time_ns - *start_ns_) break;
    now = waypoint.references;
  }
  return now;
}

bool ReferenceTrajectory::isFinished(std::int64_t time_ns) const {
  return start_ns_ && time_ns - *start_ns_ >= waypoints_.back().from_start_ns;
}

std::vector<Waypoint> readWaypoints(const std::string& text, const std::string& name) {
  std::vector<Waypoint> waypoints;
  std::istringstream lines(text);
  double seconds = 0;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> values;
    const auto fail = [&](const std::string& problem) {
      throw ConfigError(fmt::format("{}:{}: {}", name, number, problem));
    };
    for (std::string word; words >> word;) {
      try {
        values.push_back(quad_support::parseDouble(word));
      } catch (const std::invalid_argument&) {
        fail("'" + word + "' is not a number");
      }
      if (!std::isfinite(values.back())) fail("'" + word + "' is not finite");
    }
    if (values.empty()) continue;
    if (values.size() != 5)
      fail(fmt::format(
          "{} numbers; must be 5: seconds after the one before, x, y, z [m], yaw [degrees]",
          values.size()));
    constexpr double kLongest = 1e6;  // [s]
    if (!(values[0] >= 0 && values[0] <= kLongest))
      fail(fmt::format("{} s after the one before; must lie in [0, 1e6]", values[0]));
    seconds += values[0];
    constexpr double kDegree = 3.14159265358979323846 / 180;
    waypoints.push_back(
        {std::llround(seconds * 1e9), {values[1], values[2], values[3], values[4] * kDegree}});
  }
  if (waypoints.empty()) throw ConfigError(name + ": no waypoint");
  return waypoints;
}

bool SampleClock::isSample(std::int64_t time_ns) {
  const bool back = last_ns_ && time_ns < *last_ns_;
  const double spacing = last_ns_ && !back ? static_cast<double>(time_ns - *last_ns_) : 0;
  last_ns_ = time_ns;
  if (last_sample_ns_ && !back &&
      static_cast<double>(time_ns - *last_sample_ns_) < period_ns_ - 0.5 * spacing)
    return false;
  last_sample_ns_ = time_ns;
  return true;
}

}  // namespace quad_control
