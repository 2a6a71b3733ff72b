#include <gtest/gtest.h>

#include <cmath>

#include "quad_experiment/middleware.hpp"

using namespace quad_experiment;

namespace {

const MiddlewareConfig kThesis = {0.1, 0.045, 0.0056, 0.001};

}  // namespace

TEST(Middleware, WithoutJitterEveryIntervalIsThePeriod) {
  const Middleware exact({0.1, 0.0, 0.0, 0.001}, 1, 0);
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_EQ(exact.interval(i).steps, 100);
    EXPECT_EQ(exact.interval(i).hold_steps, 0);
  }
  EXPECT_EQ(exact.totalSteps(60), 6000);
}

TEST(Middleware, JitterHasTheConfiguredSpread) {
  const Middleware noisy(kThesis, 1, 0);
  const int n = 20000;
  double sum = 0, square = 0;
  for (int i = 0; i < n; ++i) {
    const Interval interval = noisy.interval(static_cast<std::uint64_t>(i));
    EXPECT_EQ(interval.hold_steps, 45);
    EXPECT_GE(interval.steps, 46);
    sum += interval.steps;
    square += std::pow(interval.steps - 100.0, 2);
  }
  // Rounding to whole steps adds 1/12 to the variance of 5.6² steps²; five standard errors of mean
  // and variance.
  const double variance = 5.6 * 5.6 + 1.0 / 12;
  EXPECT_NEAR(sum / n, 100.0, 5 * std::sqrt(variance / n));
  EXPECT_NEAR(square / n, variance, 5 * variance * std::sqrt(2.0 / n));
}

TEST(Middleware, LatencyIsAlwaysFollowedByTheNewCommand) {
  const Middleware wild({0.1, 0.09, 0.1, 0.001}, 3, 0);
  int shortest = 1000;
  for (std::uint64_t i = 0; i < 1000; ++i) shortest = std::min(shortest, wild.interval(i).steps);
  EXPECT_EQ(shortest,
            91);  // max(latency + 1, …): a jitter of 0.1 s reaches the bound in 1000 draws
}

TEST(Middleware, FlightsAndSeedsHaveTheirOwnStreams) {
  const auto lengths = [](std::uint64_t seed, std::uint64_t flight) {
    std::vector<int> result;
    for (std::uint64_t i = 0; i < 50; ++i)
      result.push_back(Middleware(kThesis, seed, flight).interval(i).steps);
    return result;
  };
  EXPECT_EQ(lengths(1, 0), lengths(1, 0));
  EXPECT_NE(lengths(1, 0), lengths(2, 0));
  EXPECT_NE(lengths(1, 0), lengths(1, 1));
}
