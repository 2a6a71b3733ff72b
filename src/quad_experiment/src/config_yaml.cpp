#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "quad_experiment/experiment_config.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/number_format.hpp"
#include "quad_support/sha256.hpp"

namespace quad_experiment {
namespace {

using quad_support::shortest;

template <class Values>
std::string list(const Values& values) {
  std::vector<std::string> texts;
  for (const auto& value : values) texts.push_back(shortest(static_cast<double>(value)));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string gains(const quad_control::PiGains& g) {
  return list(
      std::vector<double>{g.position, g.position_integral, g.velocity, g.velocity_integral});
}

/// For between double quotes.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

const char* word(bool value) { return value ? "true" : "false"; }

/// The keys that may be left out, where they are not.
std::string options(const quad_sim::SimulationConfig& simulation) {
  const quad_sim::SimulatorOptions& o = simulation.options;
  std::string y, names;
  quad_sim::RotorsQuirks quirks = o.quirks;
  for (const std::string& name : quad_sim::RotorsQuirks::names()) {
    if (quirks.byName(name)) names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) y += "  quirks: [" + names + "]\n";
  if (o.seed != 0) y += fmt::format("  seed: {}  # of turbulence and sensors\n", o.seed);
  if (!simulation.wind) return y;
  std::vector<std::string> wind;
  for (const auto& [key, values] : *simulation.wind)
    wind.push_back(key + ": " + (values.size() == 1 ? shortest(values[0]) : list(values)));
  return y + fmt::format("  wind: {{{}}}\n", fmt::join(wind, ", "));
}

std::string yaml(const ExperimentConfig& c, const std::string& urdf) {
  const auto& s = c.simulation;
  std::string y;
  y += fmt::format("vehicle:\n  urdf: \"{}\"\n  namespace: {}\n  mass: {}  # [kg]\n", escaped(urdf),
                   s.vehicle_namespace, s.mass ? shortest(*s.mass) : "urdf");
  y += fmt::format(
      "simulation:\n  step: {}  # [s]\n  gravity: {}  # [m/s^2]\n  multibody: {}\n  profile: {}\n  "
      "ground: {}\n"
      "  initial_altitude: {}  # [m]\n",
      shortest(s.options.step), shortest(s.options.gravity),
      s.options.multibody == quad_sim::Multibody::kFolded ? "folded" : "hinged",
      s.options.profile == quad_sim::Profile::kDefault ? "default" : "rotors_compat",
      word(s.options.ground), shortest(s.initial_altitude));
  y += options(s);
  y += fmt::format(
      "timing:\n  sampling_period: {}  # [s]\n  mode: {}\n  forgetting_factor: {}\n  latency: {}  "
      "# [s]\n"
      "  jitter_std: {}  # [s]\n",
      shortest(c.timing.sampling_period), quad_control::toString(c.timing.mode),
      shortest(c.timing.forgetting_factor), shortest(c.timing.latency),
      shortest(c.timing.jitter_std));
  y += fmt::format(
      "control:\n  roll_pitch: {}\n  yaw: {}\n  altitude: {}\n  position_loop: {}\n  hold_time: {} "
      " # [s]\n",
      gains(c.control.roll_pitch), gains(c.control.yaw), gains(c.control.altitude),
      word(c.control.position_loop), shortest(c.control.hold_time));
  y += fmt::format("estimate:\n  sampling_period: {}  # [s]\n  mass: {}  # [kg]\n",
                   shortest(c.estimate.parameters.sampling_period),
                   shortest(c.estimate.parameters.mass));
  if (c.estimate.drawn)
    y += fmt::format("  # drawn: closeness {}, seed {}\n", shortest(c.estimate.closeness),
                     c.estimate.seed);
  const DesignConfig& d = c.design;
  y += fmt::format(
      "design:\n  num_samples: {}\n  harmonics: {}\n  phase: {}\n  gamma_w: {}\n  "
      "desired_closeness: {}\n  method: {}\n"
      "  signal: {}\n",
      d.num_samples, list(d.harmonics), explore_opt::toString(d.phase), shortest(d.gamma_w),
      shortest(d.desired_closeness), explore_opt::toString(d.method),
      d.fly_design ? "designed" : "given");
  if (!d.amplitudes.empty()) y += fmt::format("  amplitudes: {}  # [N]\n", list(d.amplitudes));
  y += fmt::format("  amplitude_margin: {}\n", shortest(d.amplitude_margin));
  y += fmt::format("comparison: [{}]\nseed: {}\n", c.fly_gaussian ? "gaussian" : "", c.seed);
  return y;
}

}  // namespace

std::string toYaml(const ExperimentConfig& config) {
  return yaml(config,
              std::filesystem::absolute(config.simulation.urdf).lexically_normal().string());
}

std::string configHash(const ExperimentConfig& config) {
  const std::string& urdf = config.simulation.urdf;
  const std::string name = std::filesystem::path(urdf).filename().string();
  return quad_support::sha256(yaml(config, name) +
                              quad_support::sha256(quad_support::readFile(urdf)));
}

}  // namespace quad_experiment
