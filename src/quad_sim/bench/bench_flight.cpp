// A flight of 43 s at 1 ms, 100 steps an interval with a command each, against the same number of bare dWorldStep calls
// on one body: what everything that is not ODE costs. The last line is the ratio of the two for hover, measured by itself in
// turns, so that it does not depend on the benchmarks chosen or on how often they repeat.
#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

#include "quad_sim/simulation_config.hpp"

namespace {

constexpr int kIntervals = 430, kStepsPerInterval = 100;
constexpr double kStep = 0.001, kAltitude = 5000.0;

quad_sim::VehicleModel hummingbird() { return quad_sim::loadVehicle(quad_sim::findUrdf("hummingbird.urdf", "")); }

/// One body of the vehicle's mass and inertia in a world of ODE's own.
class BareWorld {
 public:
  BareWorld() {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, -9.8);
    body_ = dBodyCreate(world_);
    const quad_sim::VehicleModel model = hummingbird();
    const Eigen::Matrix3d& I = model.inertia_B;
    dMass mass;
    dMassSetParameters(&mass, model.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    dBodySetMass(body_, &mass);
  }
  ~BareWorld() { dWorldDestroy(world_); }
  BareWorld(const BareWorld&) = delete;
  BareWorld& operator=(const BareWorld&) = delete;

  void fly() {
    dBodySetPosition(body_, 0, 0, kAltitude);
    for (int i = 0; i < kIntervals * kStepsPerInterval; ++i) dWorldStep(world_, kStep);
    benchmark::DoNotOptimize(dBodyGetPosition(body_)[2]);
  }

 private:
  dWorldID world_;
  dBodyID body_;
};

quad_sim::SimulatorOptions simulatorOptions() {
  quad_sim::SimulatorOptions options;
  options.step = kStep;
  return options;
}

class Flight {
 public:
  /// @param imbalance  [rad/s] by which one rotor's command differs: 0 hovers, more tumbles
  explicit Flight(double imbalance) : model_(hummingbird()), simulator_(model_, simulatorOptions()) {
    simulator_.setStartState(quad_sim::equilibrium(model_, simulatorOptions().gravity, kAltitude));
    command_ = simulator_.command();
    command_[0] += imbalance;
    measurement_ = simulator_.measure();
  }

  void fly() {
    simulator_.reset();
    for (int i = 0; i < kIntervals; ++i) {
      simulator_.setCommand(command_);
      simulator_.advance(kStepsPerInterval);
      simulator_.measure(measurement_);
    }
    benchmark::DoNotOptimize(measurement_.odometry.p_WB.z());
  }

 private:
  quad_sim::VehicleModel model_;
  quad_sim::Simulator simulator_;
  std::vector<double> command_;
  quad_sim::Measurement measurement_;
};

void bareWorldStep(benchmark::State& state) {
  BareWorld world;
  for (auto _ : state) world.fly();
}
BENCHMARK(bareWorldStep)->Unit(benchmark::kMillisecond);

void flight(benchmark::State& state, double imbalance) {
  Flight flight(imbalance);
  for (auto _ : state) flight.fly();
}
BENCHMARK_CAPTURE(flight, hovering, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flight, tumbling, 0.5)->Unit(benchmark::kMillisecond);

template <class Plant>
double secondsOf(Plant& plant) {
  const auto start = std::chrono::steady_clock::now();
  plant.fly();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Best of each: other work on the machine only adds time. In turns, so that a slow spell meets both.
void printRatio() {
  constexpr int kRepetitions = 20;
  BareWorld world;
  Flight hover(0.0);
  double bare = std::numeric_limits<double>::infinity(), full = bare;
  for (int i = 0; i < kRepetitions; ++i) {
    bare = std::min(bare, secondsOf(world));
    full = std::min(full, secondsOf(hover));
  }
  std::printf("ratio flight/bare = %.3f (limit 1.25, goal 1.05), hover, best of %d: %.2f ms / %.2f ms\n", full / bare,
              kRepetitions, 1e3 * full, 1e3 * bare);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  printRatio();
}
