// A flight of 43 s at 1 ms, 100 steps an interval with a command each, against the same number of
// bare dWorldStep calls on one body: what everything that is not ODE costs. The last line is the
// ratio of the two for hover, measured by itself in turns, so that it does not depend on the
// benchmarks chosen or on how often they repeat.
#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include <cstdio>

#include "flights.hpp"

namespace {

using quad_sim::Multibody;
using namespace quad_sim::bench;

constexpr int kIntervals = 430;

/// One body of the vehicle's mass and inertia in a world of ODE's own.
class BareWorld {
 public:
  BareWorld() {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, -kGravity);
    body_ = dBodyCreate(world_);
    const quad_sim::VehicleModel model = quad_sim::bench::hummingbird();
    const Eigen::Matrix3d& I = model.inertia_B;
    dMass mass;
    dMassSetParameters(&mass, model.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2),
                       I(1, 2));
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

void bareWorldStep(benchmark::State& state) {
  BareWorld world;
  for (auto _ : state) world.fly();
}
BENCHMARK(bareWorldStep)->Unit(benchmark::kMillisecond);

void flight(benchmark::State& state, double imbalance) {
  Flight flight(Multibody::kFolded, kIntervals, imbalance);
  for (auto _ : state) benchmark::DoNotOptimize(flight.fly());
}
BENCHMARK_CAPTURE(flight, hovering, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flight, tumbling, 0.5)->Unit(benchmark::kMillisecond);

void printRatio() {
  constexpr int kRepetitions = 20;
  BareWorld world;
  Flight hover(Multibody::kFolded, kIntervals);
  const auto [bare, full] =
      quad_sim::bench::bestInTurns<2>({[&] { world.fly(); }, [&] { hover.fly(); }}, kRepetitions);
  std::printf(
      "ratio flight/bare = %.3f (limit 1.25, goal 1.05), hover, best of %d: %.2f ms / %.2f ms\n",
      full / bare, kRepetitions, 1e3 * full, 1e3 * bare);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  printRatio();
}
