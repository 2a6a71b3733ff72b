#include "quad_experiment/experiment.hpp"

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <future>
#include <nlohmann/json.hpp>

#include "explore_opt/altitude_model.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/exploration_signal.hpp"
#include "quad_experiment/table.hpp"
#include "quad_support/errors.hpp"

namespace quad_experiment {
namespace {

std::vector<double> toSamples(const Eigen::MatrixXd& signal) {
  return {signal.data(), signal.data() + signal.size()};
}

std::vector<double> flownAmplitudes(const ExperimentConfig& config,
                                    const explore_opt::DesignResult& design) {
  std::vector<double> amplitudes = config.design.amplitudes;
  if (config.design.fly_design) {
    if (!design.feasible())
      throw quad_support::NegativeAnswer("no exploration signal: " + design.message);
    amplitudes = toSamples(design.amplitudes);
  }
  for (double& a : amplitudes) a *= 1.0 + config.design.amplitude_margin;
  return amplitudes;
}

std::vector<double> gaussian(const ExperimentPlan& plan) {
  double energy = 0.0;
  for (const double u : plan.targeted_signal) energy += u * u;
  return toSamples(explore_opt::gaussianSignal(energy, 1, plan.config.design.num_samples,
                                               plan.config.seed, 0,
                                               kSignalStream + kGaussianFlight));
}

const char* nameOf(Flight flight) { return flight == kTargetedFlight ? "targeted" : "random"; }

std::uint64_t holdIntervals(const ExperimentConfig& config) {
  return static_cast<std::uint64_t>(
      std::llround(config.control.hold_time / config.timing.sampling_period));
}

/// Simulated time [ns] of the hold's end: known beforehand in lock-step, where the middleware's
/// draws are known.
std::int64_t explorationStart(const ExperimentConfig& config, const Middleware& middleware) {
  if (config.timing.mode == quad_control::TimingMode::kWallclock)
    return std::llround(config.control.hold_time * 1e9);
  return middleware.totalSteps(holdIntervals(config)) *
         std::llround(config.simulation.options.step * 1e9);
}

}  // namespace

explore_opt::ExplorationProblem designProblem(const ExperimentConfig& config) {
  const auto& estimate = config.estimate.parameters;
  const auto model = explore_opt::altitudeModel(estimate.mass, estimate.sampling_period,
                                                config.simulation.options.gravity);
  explore_opt::ExplorationProblem problem;
  problem.A = model.A;
  problem.B = model.B;
  problem.lines.num_samples = config.design.num_samples;
  problem.lines.harmonics = config.design.harmonics;
  problem.phase = config.design.phase;
  problem.gamma_w = config.design.gamma_w;
  problem.D_des = Eigen::MatrixXd::Constant(1, 1, config.design.desired_closeness);
  return problem;
}

ExperimentPlan planExperiment(const ExperimentConfig& config, DesignMemory* designs) {
  ExperimentPlan plan;
  plan.config = config;
  plan.knowledge = {{config.timing.sampling_period, plan.config.vehicle().mass},
                    config.estimate.parameters,
                    config.simulation.options.gravity,
                    config.design.num_samples,
                    config.design.gamma_w,
                    config.design.desired_closeness};
  plan.start = judgeStart(plan.knowledge);
  plan.problem = designProblem(config);
  explore_opt::DesignOptions options;
  options.method = config.design.method;
  plan.design = designs ? designs->design(plan.problem, options.method)
                        : explore_opt::designExploration(plan.problem, options);
  plan.amplitudes = flownAmplitudes(config, plan.design);
  const auto rows = static_cast<Eigen::Index>(plan.amplitudes.size());
  plan.targeted_signal = toSamples(
      explore_opt::multisine(plan.problem.lines, plan.problem.phase,
                             Eigen::Map<const Eigen::MatrixXd>(plan.amplitudes.data(), rows, 1)));
  if (config.fly_gaussian) plan.gaussian_signal = gaussian(plan);
  return plan;
}

ExperimentPlan withSeed(ExperimentPlan plan, std::uint64_t seed) {
  plan.config.seed = seed;
  if (plan.config.fly_gaussian) plan.gaussian_signal = gaussian(plan);
  return plan;
}

FlightSpec flightSpec(const ExperimentPlan& plan, const std::vector<double>& signal,
                      const Middleware& middleware) {
  const ExperimentConfig& config = plan.config;
  FlightSpec spec;
  spec.plan.references.z = config.simulation.initial_altitude;
  spec.plan.feed_forward_mass = plan.knowledge.estimate.mass;
  spec.plan.gravity = plan.knowledge.gravity;
  // The integral part carries what the feed-forward leaves, so that the hold begins in equilibrium.
  spec.plan.initial_altitude_effort = quad_control::equilibriumEffort(
      plan.config.vehicle().mass, plan.knowledge.estimate.mass, plan.knowledge.gravity);
  spec.plan.exploration_signal = signal;
  if (!signal.empty()) spec.plan.exploration_start_ns = explorationStart(config, middleware);
  spec.end_of_hold = config.control.hold_time;
  return spec;
}

FlightResult flyAndJudge(const ExperimentPlan& plan, Plant& plant, Flight flight,
                         const FlightProgress& progress) {
  const Middleware middleware(middlewareConfig(plan.config), plan.config.seed, flight);
  const std::vector<double>& signal =
      flight == kTargetedFlight ? plan.targeted_signal : plan.gaussian_signal;
  const quad_control::Mixer mixer =
      quad_control::Mixer(quad_control::rotorGeometry(plan.config.vehicle()));
  const double feedforward = plan.knowledge.feedforward();
  const auto begin = std::chrono::steady_clock::now();
  FlightResult result;
  result.name = nameOf(flight);
  result.trajectory = fly(plant, flightSpec(plan, signal, middleware), middleware, progress);
  result.timing = plant.timing();
  result.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.verdict = judgeFlight(
      plan.knowledge, explorationData(result.trajectory, mixer, feedforward), result.trajectory);
  return result;
}

std::string ExperimentResult::problem() const {
  const FlightVerdict& v = targeted().verdict;
  if (v.ok()) return "";
  const std::string broken = "the promise was broken: ";
  if (!v.fit.exciting) return broken + "the data do not determine the model";
  if (v.gamma_w_falsified)
    return broken +
           fmt::format("the data falsify gamma_w (G = {:.4g} < 0); raise design.gamma_w", v.set->G);
  if (!v.exploration_condition) {
    return broken +
           fmt::format(
               "the exploration condition (1.10) is not met (lambda_min(S) = {:.4g}); raise "
               "design.amplitude_margin or num_samples",
               v.set->lambda_min_S);
  }
  return broken + fmt::format("the objective (1.9) is {:.4g} > 1", v.objective);
}

int ExperimentResult::exitCode() const {
  return ok() ? quad_support::kDone : quad_support::kNegativeAnswer;
}

namespace {

FlightResult flyOne(const ExperimentPlan& plan, Plant& plant, Flight flight, Record record,
                    const FlightProgress& progress) {
  FlightResult flown = flyAndJudge(plan, plant, flight, progress);
  if (record == Record::kCsv) {
    flown.csv = toCsv(flown.trajectory,
                      quad_control::Mixer(quad_control::rotorGeometry(plan.config.vehicle())),
                      plan.knowledge.feedforward());
  }
  return flown;
}

/// The random flight, or why it ended early: it never decides.
struct RandomFlight {
  std::optional<FlightResult> flown;
  std::string failure;
};

RandomFlight flyRandom(const ExperimentPlan& plan, Plant& plant, Record record,
                       const FlightProgress& progress) try {
  return {flyOne(plan, plant, kGaussianFlight, record, progress), ""};
} catch (const quad_support::SimulationError& e) {
  return {std::nullopt, e.what()};
}

}  // namespace

ExperimentResult flyExperiment(const ExperimentPlan& plan, const std::vector<Plant*>& plants,
                               const std::string& mode, Record record,
                               const std::function<FlightProgress(Flight)>& progress) {
  const auto watch = [&](Flight flight) { return progress ? progress(flight) : FlightProgress(); };
  ExperimentResult result;
  result.mode = mode;
  std::future<RandomFlight> aside;  // its destructor waits, so the plan outlives the flight
  if (plan.config.fly_gaussian && plants.size() > 1) {
    aside = std::async(std::launch::async, [&] { return flyRandom(plan, *plants[1], record, {}); });
  }
  result.flights.push_back(
      flyOne(plan, *plants[0], kTargetedFlight, record, watch(kTargetedFlight)));
  if (plan.config.fly_gaussian) {
    RandomFlight random =
        aside.valid() ? aside.get() : flyRandom(plan, *plants[0], record, watch(kGaussianFlight));
    if (random.flown) result.flights.push_back(std::move(*random.flown));
    result.random_failure = random.failure;
  }
  result.time = judgeTime(result.targeted().trajectory, plan.config.timing.sampling_period);
  result.delay = judgeDelay(result.targeted().timing);
  return result;
}

ExperimentResult runExperiment(const ExperimentConfig& config, const std::vector<Plant*>& plants,
                               const std::string& mode, quad_support::ResultDirectory& results,
                               const StatusCallback& status) {
  const auto begin = std::chrono::steady_clock::now();
  const auto tell = [&](const ExperimentStatus& s) {
    if (status) status(s);
  };
  tell({"", "design"});
  const ExperimentPlan plan = planExperiment(config);
  results.write("config.yaml", toYaml(config));
  results.write("design.json", explore_opt::designToJson(plan.problem, plan.design).dump(2) + "\n");
  results.write("provenance.json", provenanceJson(plan, mode).dump(2) + "\n");

  const double duration =
      config.control.hold_time + config.design.num_samples * config.timing.sampling_period;
  const auto watch = [&](Flight flight) {
    return [&, flight](const quad_sim::Odometry& o) {
      const double time = static_cast<double>(o.time_ns) / 1e9;
      tell({nameOf(flight), time < config.control.hold_time ? "hold" : "explore", time, duration,
            o.p_WB.z(), climbRate(o)});
    };
  };
  ExperimentResult result = flyExperiment(plan, plants, mode, Record::kCsv, watch);
  for (const FlightResult& flown : result.flights) {
    results.write(flown.name + "/trajectory.csv", flown.csv);
    if (!flown.timing.empty())
      results.write(flown.name + "/timing.csv", timingCsv(flown.trajectory, flown.timing));
  }
  result.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  results.write("summary.json", summaryJson(plan, result).dump(2) + "\n");
  results.write("table.txt", comparisonTable(plan, result));
  results.write("table.json", comparisonJson(plan, result).dump(2) + "\n");
  tell({"", "done"});
  return result;
}

}  // namespace quad_experiment
