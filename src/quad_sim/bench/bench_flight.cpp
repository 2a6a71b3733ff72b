// A flight of 43 s at 1 ms, 100 steps an interval with a command each, against the same number of bare dWorldStep calls
// on one body: what everything that is not ODE costs. Read the ratio of the two; both rows come from one run.
#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include "quad_sim/simulation_config.hpp"

namespace {

constexpr int kIntervals = 430, kStepsPerInterval = 100;
constexpr double kStep = 0.001, kAltitude = 5000.0;

quad_sim::VehicleModel hummingbird() { return quad_sim::loadVehicle(quad_sim::findUrdf("hummingbird.urdf", "")); }

void bareWorldStep(benchmark::State& state) {
  const quad_sim::VehicleModel model = hummingbird();
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, -9.8);
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  const Eigen::Matrix3d& I = model.inertia_B;
  dMassSetParameters(&mass, model.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  dBodySetMass(body, &mass);
  for (auto _ : state) {
    dBodySetPosition(body, 0, 0, kAltitude);
    for (int i = 0; i < kIntervals * kStepsPerInterval; ++i) dWorldStep(world, kStep);
    benchmark::DoNotOptimize(dBodyGetPosition(body)[2]);
  }
  dWorldDestroy(world);
}
BENCHMARK(bareWorldStep)->Unit(benchmark::kMillisecond);

/// @param imbalance  [rad/s] by which one rotor's command differs: 0 hovers, more tumbles
void flight(benchmark::State& state, double imbalance) {
  const quad_sim::VehicleModel model = hummingbird();
  quad_sim::SimulatorOptions options;
  options.step = kStep;
  quad_sim::Simulator simulator(model, options);
  simulator.setStartState(quad_sim::equilibrium(model, options.gravity, kAltitude));
  std::vector<double> command = simulator.command();
  command[0] += imbalance;
  quad_sim::Measurement measurement = simulator.measure();
  for (auto _ : state) {
    simulator.reset();
    for (int i = 0; i < kIntervals; ++i) {
      simulator.setCommand(command);
      simulator.advance(kStepsPerInterval);
      simulator.measure(measurement);
    }
    benchmark::DoNotOptimize(measurement.odometry.p_WB.z());
  }
}
BENCHMARK_CAPTURE(flight, hovering, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flight, tumbling, 0.5)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
