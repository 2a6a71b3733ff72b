#include "quad_experiment/experiment_config.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "quad_control/flight_controller.hpp"
#include "quad_control/mixer.hpp"
#include "quad_experiment/streams.hpp"
#include "quad_support/config_reader.hpp"
#include "quad_support/errors.hpp"

namespace quad_experiment {

using quad_support::ConfigReader;
using quad_support::Range;

namespace {

constexpr std::int64_t kMaxSeed =
    9007199254740992;  // 2^53: read back exactly by every JSON and YAML reader
constexpr std::int64_t kMaxSamples = 1000000;
constexpr double kLargest =
    1e6;  // of a period [s], a mass [kg], a force [N]: beyond it a sum of squares overflows

EstimateConfig readEstimate(const ConfigReader& in, const explore_opt::AltitudeParameters& truth) {
  EstimateConfig c;
  c.drawn = in.has("draw");
  if (c.drawn) {
    if (in.has("sampling_period") || in.has("mass"))
      in.fail("draw", "replaces sampling_period and mass; give one or the other");
    const ConfigReader draw = in.section("draw");
    c.closeness = draw.number("closeness", Range::positive());
    c.seed = static_cast<std::uint64_t>(draw.integer("seed", 0, kMaxSeed));
    draw.finish();
    c.parameters = explore_opt::drawInitialEstimate(truth, c.closeness, c.seed).parameters;
  } else {
    c.parameters.sampling_period =
        in.number("sampling_period", Range{0.0, kLargest, true, false, "s"});
    c.parameters.mass = in.number("mass", Range{0.0, kLargest, true, false, "kg"});
  }
  in.finish();
  return c;
}

std::vector<int> readHarmonics(const ConfigReader& in, int num_samples) {
  const int largest = (num_samples - 1) / 2;  // the largest whole number below T/2
  std::vector<int> harmonics;
  std::set<int> seen;
  for (const auto value : in.integers("harmonics", 1, largest)) {
    const int h = static_cast<int>(value);
    if (!seen.insert(h).second) {
      in.fail(
          "harmonics",
          fmt::format("stands twice; lines must be distinct, 0 < h < T/2 = {}", num_samples / 2.0),
          static_cast<int>(harmonics.size()));
    }
    harmonics.push_back(h);
  }
  return harmonics;
}

DesignConfig readDesign(const ConfigReader& in) {
  DesignConfig c;
  c.num_samples = static_cast<int>(in.integer("num_samples", 3, kMaxSamples));
  c.harmonics = readHarmonics(in, c.num_samples);
  c.phase = explore_opt::phaseFromString(in.choice("phase", {"sin", "cos", "both"}));
  c.gamma_w = in.number("gamma_w", Range::positive());
  c.desired_closeness = in.number("desired_closeness", Range::positive());
  c.method = explore_opt::methodFromString(in.choice("method", {"global", "mm"}));
  c.fly_design = in.choice("signal", {"given", "designed"}) == "designed";
  const std::size_t carriers = c.harmonics.size() * (c.phase == explore_opt::Phase::kBoth ? 2 : 1);
  if (!c.fly_design || in.has("amplitudes"))
    c.amplitudes = in.numbers("amplitudes", Range::closed(-kLargest, kLargest, "N"), carriers);
  c.amplitude_margin = in.number("amplitude_margin", Range::closed(0.0, 10.0));
  in.finish();
  return c;
}

/// Complains about a vehicle that cannot hover or be controlled.
void requireFlyable(const quad_sim::SimulationConfig& simulation) {
  try {
    quad_sim::hoverSpeed(simulation.model, simulation.options.gravity);
    quad_control::Mixer(quad_control::rotorGeometry(simulation.model));
  } catch (const std::invalid_argument& e) {
    throw quad_support::ConfigError(simulation.urdf + ": " + e.what());
  }
}

/// What the controllers would refuse when the flight begins, said where the settings are.
void requireFlight(const ConfigReader& in, const ExperimentConfig& c) {
  const quad_sim::VehicleModel& vehicle = c.vehicle();
  const double gravity = c.simulation.options.gravity;
  if (!(gravity > 0.0))
    in.section("simulation")
        .fail("gravity", "must be > 0 m/s^2: without weight there is nothing to hold");
  if (std::llround(c.control.hold_time / c.timing.sampling_period) < 1) {
    in.section("control").fail("hold_time", fmt::format("must be at least one interval of {} s",
                                                        c.timing.sampling_period));
  }
  const double feedforward = c.estimate.parameters.mass * gravity;
  const double max_thrust = quad_control::Mixer(quad_control::rotorGeometry(vehicle)).maxThrust();
  if (feedforward >= max_thrust) {
    in.section("estimate")
        .fail(c.estimate.drawn ? "draw" : "mass",
              fmt::format("must be below {} kg: its weight {} N is more than the rotors' {} N",
                          max_thrust / gravity, feedforward, max_thrust));
  }
  const quad_control::PiGains& altitude = c.control.altitude;
  if (altitude.position_integral == 0.0 && altitude.velocity_integral == 0.0 &&
      c.estimate.parameters.mass != vehicle.mass) {
    in.section("control").fail(
        "altitude",
        fmt::format("needs an integral gain (the second or fourth): it carries the {} N that the "
                    "feed-forward of estimate.mass leaves",
                    (vehicle.mass - c.estimate.parameters.mass) * gravity));
  }
}

}  // namespace

ExperimentConfig readExperimentConfig(const std::string& path, const std::string& mode) {
  return readExperimentConfig(ConfigReader::fromFile(path), mode);
}

ExperimentConfig readExperimentConfig(const ConfigReader& in, const std::string& mode) {
  ExperimentConfig c;
  c.simulation = quad_sim::readSimulationConfig(in.section("vehicle"), in.section("simulation"));
  c.timing = quad_control::readTimingConfig(in.section("timing"), c.simulation.options.step);
  c.timing.mode = quad_control::timingMode(mode, c.timing.mode);
  if (c.timing.mode == quad_control::TimingMode::kWallclock)
    c.timing.latency = c.timing.jitter_std = 0.0;
  c.control = quad_control::readControlConfig(in.section("control"), c.timing.sampling_period);
  requireFlyable(c.simulation);
  c.estimate = readEstimate(in.section("estimate"), {c.timing.sampling_period, c.vehicle().mass});
  requireFlight(in, c);
  c.design = readDesign(in.section("design"));
  for (const auto& signal : in.choices("comparison", {"gaussian"})) {
    if (c.fly_gaussian) in.fail("comparison", signal + " stands twice");
    c.fly_gaussian = true;
  }
  c.seed = static_cast<std::uint64_t>(in.integer("seed", 0, kMaxSeed));
  in.finish();
  return c;
}

namespace {

/// What is said where time advances by `unit` and `value` is no whole number of it; else empty.
std::string roundingNote(const char* key, double value, const char* unit_key, double unit) {
  const double flown = std::round(value / unit) * unit;
  // A decimal fraction such as 0.045 is a whole number of steps up to rounding.
  if (std::abs(flown - value) <= 1e-9 * std::max(unit, value)) return "";
  return fmt::format("{} = {} s is flown as {:.9g} s, a whole number of {} = {} s: {:.3g} ms {}",
                     key, value, flown, unit_key, unit, 1e3 * std::abs(flown - value),
                     flown > value ? "more" : "less");
}

}  // namespace

std::vector<std::string> notes(const ExperimentConfig& config) {
  const quad_control::TimingConfig& timing = config.timing;
  std::vector<std::string> notes = config.vehicle().notes;
  std::vector<std::string> roundings = {roundingNote(
      "timing.latency", timing.latency, "simulation.step", config.simulation.options.step)};
  if (timing.mode ==
      quad_control::TimingMode::kLockstep) {  // on the wall clock no interval is exact
    roundings.push_back(roundingNote("control.hold_time", config.control.hold_time,
                                     "timing.sampling_period", timing.sampling_period));
  }
  for (const std::string& note : roundings)
    if (!note.empty()) notes.push_back(note);
  return notes;
}

MiddlewareConfig middlewareConfig(const ExperimentConfig& config) {
  return {config.timing.sampling_period, config.timing.latency, config.timing.jitter_std,
          config.simulation.options.step};
}

}  // namespace quad_experiment
