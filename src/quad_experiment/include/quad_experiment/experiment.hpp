/// The experiment as a straight line: design, signals, flights, identification, verdicts, results.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "explore_opt/exploration_design.hpp"
#include "quad_control/mixer.hpp"
#include "quad_experiment/design_memory.hpp"
#include "quad_experiment/experiment_config.hpp"
#include "quad_experiment/flight.hpp"
#include "quad_experiment/plant.hpp"
#include "quad_experiment/streams.hpp"
#include "quad_experiment/verdicts.hpp"
#include "quad_sim/vehicle_model.hpp"
#include "quad_support/atomic_file.hpp"

namespace quad_experiment {

/// Everything fixed before the first flight.
struct ExperimentPlan {
  ExperimentConfig config;
  Knowledge knowledge;
  InitialVerdict start;
  explore_opt::ExplorationProblem problem;
  explore_opt::DesignResult design;
  std::vector<double> amplitudes;       ///< flown [N], margin included
  std::vector<double> targeted_signal;  ///< T samples [N]
  std::vector<double> gaussian_signal;  ///< of the same energy; empty if not asked for
};

/// The design problem of a configuration: nominal model of the estimate, D_des = lambda I.
explore_opt::ExplorationProblem designProblem(const ExperimentConfig& config);

/// Designs and generates signals. @throws quad_support::ConfigError as readExperimentConfig();
/// quad_support::NegativeAnswer if the design that was to be flown does not exist, with the
/// solver's reason
/// @param designs  if given, asked for the design
ExperimentPlan planExperiment(const ExperimentConfig& config, DesignMemory* designs = nullptr);

/// The same plan with another seed: vehicle, model and design stay, the random signal is drawn
/// anew.
ExperimentPlan withSeed(ExperimentPlan plan, std::uint64_t seed);

/// The flight plan for a signal: hold at the start altitude in equilibrium, then explore.
FlightSpec flightSpec(const ExperimentPlan& plan, const std::vector<double>& signal,
                      const Middleware& middleware);

/// One flown signal and what it says.
struct FlightResult {
  std::string name;  ///< "targeted" or "random": its folder
  std::string csv;   ///< trajectory.csv; filled by runExperiment()
  Trajectory trajectory;
  std::vector<IntervalTiming>
      timing;  ///< of the intervals; empty unless the clock on the wall paced them
  FlightVerdict verdict;
  double wall_seconds = 0.0;  ///< of the flying alone
};

FlightResult flyAndJudge(const ExperimentPlan& plan, Plant& plant, Flight flight,
                         const FlightProgress& progress = {});

struct ExperimentResult {
  std::string mode;  ///< "lockstep", "wallclock" (over ROS) or "in_process"
  std::vector<FlightResult> flights;
  TimeVerdict time;                   ///< of the targeted flight
  std::optional<DelayVerdict> delay;  ///< likewise, if the clock on the wall paced it
  std::string random_failure;  ///< why the random flight ended early, if it did; it never decides
  double wall_seconds = 0.0;

  const FlightResult& targeted() const { return flights.front(); }
  bool ok() const { return targeted().verdict.ok(); }
  int exitCode() const;
  std::string problem() const;  ///< which promise was broken, in a line; empty if ok()
};

/// What is happening, for whoever watches.
struct ExperimentStatus {
  std::string flight;          ///< "targeted", "random"; empty on the ground
  std::string phase;           ///< "design", "hold", "explore", "identify", "done"
  double time = 0.0;           ///< simulated [s] in this flight
  double duration = 0.0;       ///< of this flight, about [s]
  double z = 0.0, zdot = 0.0;  ///< altitude [m], climb rate [m/s]
};
using StatusCallback = std::function<void(const ExperimentStatus&)>;

enum class Record { kNone, kCsv };  ///< whether each flight's `csv` is filled

/// All flights of a plan, judged.
/// @param plants  one: the flights follow each other; two: they fly at the same time. The same bits
/// either way.
/// @param progress  gives a flight its progress callback; with two plants only the targeted one,
/// always from this thread
/// @throws what fly() throws, of the targeted flight; of the random one all but SimulationError
ExperimentResult flyExperiment(const ExperimentPlan& plan, const std::vector<Plant*>& plants,
                               const std::string& mode, Record record = Record::kNone,
                               const std::function<FlightProgress(Flight)>& progress = {});

/// Runs everything and fills `results` (not yet committed): config.yaml, provenance.json and
/// design.json before the first flight; trajectories (on the wall clock timing.csv beside them),
/// summary.json, table.txt and table.json after the last.
/// @param plants  as flyExperiment() takes them
ExperimentResult runExperiment(const ExperimentConfig& config, const std::vector<Plant*>& plants,
                               const std::string& mode, quad_support::ResultDirectory& results,
                               const StatusCallback& status = {});

/// summary.json.
nlohmann::ordered_json summaryJson(const ExperimentPlan& plan, const ExperimentResult& result);

/// provenance.json: versions, seed, hashes of everything that was decided before the flight.
nlohmann::ordered_json provenanceJson(const ExperimentPlan& plan, const std::string& mode);

}  // namespace quad_experiment
