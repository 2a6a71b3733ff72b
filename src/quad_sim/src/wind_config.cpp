#include "wind_config.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using quad_support::ConfigReader;
using quad_support::Range;

constexpr const char* kPlugin = "librotors_gazebo_wind_plugin.so";

struct Key {
  const char* name;
  const char* tag;    ///< of the plugin
  std::size_t count;  ///< of its numbers
  Range range;
};

/// Ranges keep the vehicle's motion far from overflow; a vehicle weighs less than a meganewton.
const std::vector<Key>& keys() {
  constexpr double kForce = 1e6, kSpeed = 1e3, kTime = 1e9;
  static const std::vector<Key> all = {
      {"force", "windForceMean", 1, Range::closed(-kForce, kForce, "N")},
      {"force_amplitude", "windForceAmplitude", 1, Range::closed(-kForce, kForce, "N")},
      {"direction", "windDirection", 3, Range::any()},
      {"speed", "windSpeedMean", 1, Range::closed(-kSpeed, kSpeed, "m/s")},
      {"speed_amplitude", "windSpeedAmplitude", 1, Range::closed(-kSpeed, kSpeed, "m/s")},
      {"frequency", "windFrequency", 1, Range::closed(0.0, 1e6, "Hz")},
      {"phase", "windPhase", 1, Range::any("rad")},
      {"gust_force", "windGustForceMean", 1, Range::closed(-kForce, kForce, "N")},
      {"gust_direction", "windGustDirection", 3, Range::any()},
      {"gust_start", "windGustStart", 1, Range::closed(0.0, kTime, "s")},
      {"gust_duration", "windGustDuration", 1, Range::closed(0.0, kTime, "s")},
      {"turbulence_intensity", "turbulenceIntensity", 3, Range::closed(0.0, kSpeed, "m/s")},
      {"turbulence_length", "turbulenceLength", 3, Range::positive("m")},
      {"turbulence_speed", "turbulenceSpeed", 1, Range{0.0, kSpeed, true, false, "m/s"}},
      {"offset", "xyzOffset", 3, Range::closed(-1e4, 1e4, "m")},
  };
  return all;
}

bool isZero(const WindConfig& wind, const std::string& key) {
  const auto at = wind.find(key);
  return at == wind.end() ||
         std::all_of(at->second.begin(), at->second.end(), [](double x) { return x == 0.0; });
}

void check(const ConfigReader& in, const WindConfig& wind) {
  for (const char* key : {"direction", "gust_direction"}) {
    if (wind.count(key) && isZero(wind, key)) in.fail(key, "must point somewhere: not all zero");
  }
  if (isZero(wind, "turbulence_intensity")) return;
  if (!wind.count("turbulence_length"))
    in.fail("turbulence_intensity", "needs turbulence_length beside it: three lengths [m]");
  if (!wind.count("turbulence_speed") && isZero(wind, "speed"))
    in.fail("turbulence_intensity",
            "needs turbulence_speed [m/s] beside it: without mean wind it says how fast the frozen "
            "field passes");
}

}  // namespace

std::optional<WindConfig> readWind(const ConfigReader& simulation) {
  if (!simulation.has("wind")) return std::nullopt;
  const ConfigReader in = simulation.section("wind");
  WindConfig wind;
  for (const Key& key : keys()) {
    if (!in.has(key.name)) continue;
    wind[key.name] = key.count == 1 ? std::vector<double>{in.number(key.name, key.range)}
                                    : in.numbers(key.name, key.range, key.count);
  }
  in.finish();
  check(in, wind);
  return wind;
}

void putWind(const WindConfig& wind, VehicleModel& model) {
  auto& plugins = model.plugins;
  plugins.erase(std::remove_if(plugins.begin(), plugins.end(),
                               [](const PluginDeclaration& p) { return p.filename == kPlugin; }),
                plugins.end());
  if (wind.empty()) return;
  PluginDeclaration declaration{kPlugin, "wind", "simulation.wind", {}};
  for (const Key& key : keys()) {
    const auto at = wind.find(key.name);
    if (at == wind.end()) continue;
    std::vector<std::string> texts;
    for (const double x : at->second) texts.push_back(quad_support::shortest(x));
    declaration.tags[key.tag] = fmt::format("{}", fmt::join(texts, " "));
  }
  plugins.push_back(std::move(declaration));
}

}  // namespace quad_sim
