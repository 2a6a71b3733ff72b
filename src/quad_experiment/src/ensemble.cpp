#include "quad_experiment/ensemble.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "quad_experiment/in_process_plant.hpp"
#include "quad_experiment/table.hpp"

namespace quad_experiment {
namespace {

std::map<std::string, double> flySeed(const ExperimentPlan& base, std::uint64_t seed,
                                      Plant& plant) {
  const ExperimentPlan plan = withSeed(base, seed);
  return comparedValues(plan, flyExperiment(plan, {&plant}, "in_process"));
}

}  // namespace

std::vector<std::map<std::string, double>> flySeeds(const ExperimentPlan& plan,
                                                    std::uint64_t first_seed, int count,
                                                    int workers,
                                                    const std::function<void(int)>& progress) {
  std::vector<std::map<std::string, double>> runs(static_cast<std::size_t>(count));
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(count));
  std::atomic<int> next{0};
  std::mutex mutex;
  int done = 0;
  const auto work = [&] {
    InProcessPlant plant(plan.config);
    for (int i = next++; i < count; i = next++) {
      const auto slot = static_cast<std::size_t>(i);
      try {
        runs[slot] = flySeed(plan, first_seed + static_cast<std::uint64_t>(i), plant);
      } catch (...) {
        errors[slot] = std::current_exception();
        next = count;  // the others finish what they fly, then stop
      }
      const std::lock_guard<std::mutex> lock(mutex);
      ++done;
      if (progress) progress(done);
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < workers; ++i) threads.emplace_back(work);
  work();
  for (auto& thread : threads) thread.join();
  for (const auto& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  return runs;
}

std::vector<double> sortedValues(const std::vector<std::map<std::string, double>>& runs,
                                 const std::string& key) {
  std::vector<double> values;
  for (const auto& run : runs) {
    const auto it = run.find(key);
    if (it != run.end()) values.push_back(it->second);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double quantile(const std::vector<double>& sorted, double q) {
  if (sorted.empty()) return std::nan("");
  const double position = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double percentileOf(const std::vector<double>& sorted, double value) {
  if (sorted.empty()) return std::nan("");
  const auto range = std::equal_range(sorted.begin(), sorted.end(), value);
  const double below = static_cast<double>(range.first - sorted.begin());
  const double equal = static_cast<double>(range.second - range.first);
  return 100.0 * (below + 0.5 * equal) / static_cast<double>(sorted.size());
}

}  // namespace quad_experiment
