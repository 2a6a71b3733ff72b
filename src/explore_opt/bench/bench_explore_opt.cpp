/// Time of a design with its certificate, and of identification. Build with the target
/// `benchmarks`.
#include <benchmark/benchmark.h>

#include "../test/thesis_problem.hpp"
#include "explore_opt/altitude_model.hpp"
#include "explore_opt/exploration_design.hpp"
#include "explore_opt/least_squares.hpp"
#include "explore_opt/set_membership.hpp"

using namespace explore_opt;
using explore_opt::testing::thesisProblem;

namespace {

void designGlobal(benchmark::State& state, Phase phase) {
  const ExplorationProblem problem = thesisProblem(phase, static_cast<int>(state.range(0)));
  DesignResult result;
  for (auto _ : state) benchmark::DoNotOptimize(result = designExploration(problem));
  state.counters["gap"] = result.gap;
  state.counters["gamma_e"] = result.gamma_e;
}

void designMm(benchmark::State& state) {
  DesignOptions options;
  options.method = DesignMethod::kMm;
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  DesignResult result;
  for (auto _ : state) benchmark::DoNotOptimize(result = designExploration(problem, options));
  state.counters["steps"] = static_cast<double>(result.iterations.size() - 1);
}

void identify(benchmark::State& state) {
  const int T = static_cast<int>(state.range(0));
  const LinearSystem truth = altitudeModel(0.73, 0.1, 0.0);
  const Eigen::MatrixXd U = gaussianSignal(5.4 * T, 1, T, 1, 0, 0);
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(2, T + 1);
  for (int k = 0; k < T; ++k) X.col(k + 1) = truth.A * X.col(k) + truth.B * U.col(k);
  for (auto _ : state) benchmark::DoNotOptimize(feasibleSet(fitLeastSquares(X, U), 20.0));
}

}  // namespace

BENCHMARK_CAPTURE(designGlobal, sin, Phase::kSin)
    ->Arg(370)
    ->Arg(3700)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(designGlobal, cos, Phase::kCos)
    ->Arg(370)
    ->Arg(3700)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(designGlobal, both, Phase::kBoth)->Arg(370)->Unit(benchmark::kMillisecond);
BENCHMARK(designMm)->Unit(benchmark::kMillisecond);
BENCHMARK(identify)->Arg(370)->Arg(3700)->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();
