/// Everything an experiment is told, from one YAML file with one set of checks, however it is
/// flown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explore_opt/exploration_design.hpp"
#include "explore_opt/exploration_signal.hpp"
#include "explore_opt/initial_estimate.hpp"
#include "quad_control/control_config.hpp"
#include "quad_experiment/middleware.hpp"
#include "quad_sim/simulation_config.hpp"
#include "quad_support/config_reader.hpp"

namespace quad_experiment {

/// Section `estimate`: the rough model the design starts from, given or drawn as in Table 2.1.
struct EstimateConfig {
  bool drawn = false;
  double closeness = 0.0;  ///< lambda_D of the draw; only if drawn
  std::uint64_t seed = 0;  ///< of the draw; only if drawn
  explore_opt::AltitudeParameters
      parameters;  ///< dT_hat [s], m_hat [kg]: given, or the result of the draw
};

/// Section `design`.
struct DesignConfig {
  int num_samples = 0;         ///< T
  std::vector<int> harmonics;  ///< whole multiples of 1/T
  explore_opt::Phase phase = explore_opt::Phase::kSin;
  double gamma_w = 0.0;            ///< bound on the disturbance's energy, Eq. (1.6)
  double desired_closeness = 0.0;  ///< lambda of D_des = lambda I
  explore_opt::DesignMethod method = explore_opt::DesignMethod::kGlobal;
  bool fly_design = false;  ///< signal: designed (true) or given (false)
  std::vector<double>
      amplitudes;  ///< [N] with signal: given; with both phases first all cosines, then all sines
  double amplitude_margin = 0.0;  ///< flown = (1 + margin) amplitudes
};

struct ExperimentConfig {
  quad_sim::SimulationConfig simulation;  ///< sections `vehicle` and `simulation`
  quad_control::TimingConfig timing;
  quad_control::ControlConfig control;
  EstimateConfig estimate;
  DesignConfig design;
  bool fly_gaussian = false;  ///< comparison: [gaussian]
  std::uint64_t seed = 0;     ///< of jitter and random signals

  const quad_sim::VehicleModel& vehicle() const { return simulation.model; }
};

/// Reads and checks the file. In wall-clock mode latency and jitter become 0: the middleware is the
/// real one.
/// @param mode  lockstep, wallclock, or empty: timing.mode of the file
/// @throws quad_support::ConfigError naming file, line, key, value and limit
ExperimentConfig readExperimentConfig(const std::string& path, const std::string& mode = "");

/// The same from a file that has been opened, perhaps with some values replaced.
ExperimentConfig readExperimentConfig(const quad_support::ConfigReader& in,
                                      const std::string& mode = "");

/// What is flown a little differently than it is written: oddities of the vehicle taken as they
/// stand, a latency that is no whole number of physics steps. Tell the user.
std::vector<std::string> notes(const ExperimentConfig& config);

/// Every value used, as YAML that reads back to the same configuration: the URDF's path is
/// absolute, a drawn estimate stands as the numbers drawn.
std::string toYaml(const ExperimentConfig& config);

/// SHA-256 of every value used and of the URDF's content; the same wherever the files lie.
std::string configHash(const ExperimentConfig& config);

MiddlewareConfig middlewareConfig(const ExperimentConfig& config);

}  // namespace quad_experiment
