#include <fmt/core.h>

#include <cmath>
#include <cstdio>

#include "commands.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

using namespace quad_experiment;

namespace {

constexpr double kSettled = 0.02;    // of the step: the usual 2 % band
constexpr double kHighest = 1000.0;  // [m] farther than the longest flight can settle

}  // namespace

int step(const StepOptions& options) {
  if (!std::isfinite(options.duration))
    throw quad_support::ConfigError(
        fmt::format("--duration = {}; must be 0.5..600 s", options.duration));
  if (!(std::abs(options.height) > 0.0 && std::abs(options.height) <= kHighest)) {
    throw quad_support::ConfigError(fmt::format(
        "--height = {}; must lie in [-{}, {}] m and not be 0", options.height, kHighest, kHighest));
  }
  const ExperimentConfig config = readExperimentConfig(options.config);
  const ExperimentPlan plan = planExperiment(config);
  const Middleware middleware(middlewareConfig(config), config.seed, kTargetedFlight);
  FlightSpec spec = flightSpec(plan, {}, middleware);
  spec.plan.references.z += options.height;
  spec.end_of_hold = options.duration;
  quad_support::ResultDirectory results(options.out, options.force);
  results.write("config.yaml", toYaml(config));
  InProcessPlant plant(config);
  const Trajectory trajectory = fly(plant, spec, middleware);
  const quad_control::Mixer mixer(quad_control::rotorGeometry(plan.config.vehicle()));
  results.write("trajectory.csv", toCsv(trajectory, mixer, plan.knowledge.feedforward()));
  results.commit();

  const TrajectoryRow& before_last = trajectory.rows.at(trajectory.rows.size() - 2);
  const double weight = plan.config.vehicle().mass * plan.knowledge.gravity;
  double overshoot = 0.0;
  for (const auto& row : trajectory.rows) {
    const double error =
        (row.state.odometry.p_WB.z() - spec.plan.references.z) * (options.height < 0 ? -1 : 1);
    overshoot = std::max(overshoot, error);
  }
  const double final_error =
      trajectory.rows.back().state.odometry.p_WB.z() - spec.plan.references.z;
  tellResults(
      fmt::format("altitude step of {:g} m: final error {:.3g} m, overshoot {:.3g} m, final thrust "
                  "{:.6f} N (m g = {:.6f} N)\n",
                  options.height, final_error, overshoot, before_last.command.thrust, weight),
      results.path());
  if (std::abs(final_error) <= kSettled * std::abs(options.height)) return quad_support::kDone;
  std::fprintf(
      stderr,
      "quad_experiment: not settled after %g s: error %.3g m, more than %g %% of the step\n",
      options.duration, final_error, 100.0 * kSettled);
  return quad_support::kNegativeAnswer;
}
