#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "quad_control/time_manager.hpp"

namespace quad_control {
namespace {

TEST(ForgettingMean, RecursionEqualsThePrintedSum) {
  std::mt19937 random(2);
  std::exponential_distribution<double> delay(100.0);
  for (const double lambda : {0.5, 0.94, 0.999}) {
    ForgettingMean mean(lambda);
    std::vector<double> x;
    for (int k = 1; k <= 400; ++k) {
      x.push_back(delay(random));
      mean.add(x.back());
      double sum = 0.0, weight = 0.0;
      for (int i = 1; i <= k; ++i) {
        const double w = std::pow(lambda, k - i);
        sum += w * x[static_cast<std::size_t>(i - 1)];
        weight += w;
      }
      // Values of 0.01 s; the recursion forgets its own rounding within 1/(1 - lambda) = 1000
      // terms.
      EXPECT_NEAR(mean.mean(), sum / weight, 1e-15) << lambda << " " << k;
    }
  }
}

TEST(ForgettingMean, IsZeroBeforeTheFirstValueAndTheFirstValueAfter) {
  ForgettingMean mean(0.94);
  EXPECT_EQ(mean.mean(), 0.0);
  mean.add(0.3);
  EXPECT_DOUBLE_EQ(mean.mean(), 0.3);
  mean.reset();
  EXPECT_EQ(mean.mean(), 0.0);
  EXPECT_THROW(ForgettingMean(1.0), std::invalid_argument);
  EXPECT_THROW(ForgettingMean(0.0), std::invalid_argument);
}

TEST(TimeManager, WaitsTheRest) {
  TimeManager time(0.94);
  EXPECT_DOUBLE_EQ(time.waitFor(0.15), 0.15);  // nothing known yet
  time.measured(0.15, 0.17);
  EXPECT_NEAR(time.estimatedDelay(), 0.02, 1e-16);
  EXPECT_NEAR(time.waitFor(0.15), 0.13, 1e-16);
  time.measured(0.0, 10.0);
  EXPECT_EQ(time.waitFor(0.15), 0.0);  // never negative
  time.reset();
  EXPECT_DOUBLE_EQ(time.waitFor(0.15), 0.15);
}

TEST(TimeManager, MeanIntervalReachesTheDesiredOne) {
  // Thesis Figs. 1.6 and 1.7: 0.15 s asked for 38 s, a service time that is random around a mean
  // that drifts.
  std::mt19937 random(4);
  std::gamma_distribution<double> jitter(4.0, 0.0015);
  TimeManager time(0.94);
  IntervalStatistics statistics;
  for (int k = 0; k < 253; ++k) {
    const double wait = time.waitFor(0.15);
    const double interval = wait + 0.01 + 0.005 * std::sin(k / 40.0) + jitter(random);
    time.measured(wait, interval);
    if (k > 0) statistics.add(interval, 0.15);  // the first one comes before anything is known
  }
  // Standard deviation 3 ms of one interval, of a mean over 252 with negative correlation below 0.2
  // ms; the drift is followed with 1/(1 - 0.94) = 17 intervals' delay, 2 ms at most and of either
  // sign.
  EXPECT_NEAR(statistics.mean(), 0.15, 3e-4);
}

TEST(IntervalStatistics, ByHand) {
  IntervalStatistics statistics;
  EXPECT_EQ(statistics.std(), 0.0);
  for (const double interval : {0.1, 0.11, 0.12}) statistics.add(interval, 0.1);
  EXPECT_EQ(statistics.count(), 3);
  EXPECT_NEAR(statistics.mean(), 0.11, 1e-16);
  EXPECT_NEAR(statistics.std(), 0.01, 1e-16);
  EXPECT_NEAR(statistics.maxAbsError(), 0.02, 1e-16);
}

}  // namespace
}  // namespace quad_control
