// The thesis's targeted flight with controllers and log, in one process, against the same number of
// bare dWorldStep calls on one body. The two take turns, the best of each counts, and the ratio is
// what one reads.
#include <ode/ode.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"

namespace {

using namespace quad_experiment;

constexpr int kRounds = 40;
constexpr double kLimit = 1.25, kGoal = 1.05;  // of the ratio

template <class F>
double milliseconds(const F& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

/// One body of the vehicle's mass and inertia, falling freely.
class BareWorld {
 public:
  BareWorld(const quad_sim::VehicleModel& vehicle, double step)
      : step_(step), world_(dWorldCreate()) {
    dWorldSetGravity(world_, 0, 0, -9.8);
    const Eigen::Matrix3d& I = vehicle.inertia_B;
    dMass mass;
    dMassSetParameters(&mass, vehicle.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2),
                       I(1, 2));
    dBodySetMass(dBodyCreate(world_), &mass);
  }
  ~BareWorld() { dWorldDestroy(world_); }
  BareWorld(const BareWorld&) = delete;
  BareWorld& operator=(const BareWorld&) = delete;
  void run(std::int64_t steps) {
    for (std::int64_t i = 0; i < steps; ++i) dWorldStep(world_, step_);
  }

 private:
  double step_;
  dWorldID world_;
};

}  // namespace

int main(int argc, char** argv) {
  const ExperimentPlan plan =
      planExperiment(readExperimentConfig(argc > 1 ? argv[1] : "config/thesis.yaml"));
  const ExperimentConfig& config = plan.config;
  const Middleware middleware(middlewareConfig(config), config.seed, kTargetedFlight);
  const FlightSpec spec = flightSpec(plan, plan.targeted_signal, middleware);
  const quad_control::Mixer mixer(quad_control::rotorGeometry(plan.config.vehicle()));
  InProcessPlant plant(config);
  const Trajectory once = fly(plant, spec, middleware);
  const double step = config.simulation.options.step;
  const auto steps =
      std::llround(static_cast<double>(once.rows.back().state.odometry.time_ns) * 1e-9 / step);
  BareWorld bare(plan.config.vehicle(), step);
  double best_bare = HUGE_VAL, best_flight = HUGE_VAL, best_log = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    Trajectory trajectory;
    std::string csv;
    best_bare = std::min(best_bare, milliseconds([&] { bare.run(steps); }));
    best_flight =
        std::min(best_flight, milliseconds([&] { trajectory = fly(plant, spec, middleware); }));
    best_log = std::min(best_log, milliseconds([&] {
                          csv = toCsv(trajectory, mixer, plan.knowledge.feedforward());
                        }));
    if (csv.empty()) return 1;
  }
  std::printf("bare dWorldStep, %lld steps %20.2f ms\n", static_cast<long long>(steps), best_bare);
  std::printf("flight with control and record %17.2f ms\n", best_flight);
  std::printf("printing trajectory.csv %24.2f ms\n", best_log);
  std::printf("flight / bare %34.3f     (limit %.2f, goal %.2f)\n", best_flight / best_bare, kLimit,
              kGoal);
  return 0;
}
