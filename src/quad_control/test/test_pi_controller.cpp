#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "quad_control/pi_controller.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const PiGains kGains{2.0, 0.5, 3.0, 0.25};

TEST(PiController, StepAnswerByHand) {
  PiController pi(kGains, 0.1, {-kInf, kInf});
  // e^p = 1, e^v = 2 held: u = 2 + 6 + k (0.5 * 1 + 0.25 * 2) * 0.1, and nothing summed at k = 0.
  EXPECT_DOUBLE_EQ(pi.update(1.0, 2.0), 8.0);
  EXPECT_DOUBLE_EQ(pi.update(1.0, 2.0), 8.1);
  EXPECT_DOUBLE_EQ(pi.update(1.0, 2.0), 8.2);
  EXPECT_DOUBLE_EQ(pi.positionIntegral(), 0.2);
  EXPECT_DOUBLE_EQ(pi.velocityIntegral(), 0.4);
}

TEST(PiController, EqualsThePrintedSum) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  PiController pi(kGains, 0.1, {-kInf, kInf});
  pi.reset(1.5);
  std::vector<double> ep, ev;
  for (int k = 0; k < 300; ++k) {
    ep.push_back(normal(random));
    ev.push_back(normal(random));
    double sum_p = 1.5 / kGains.position_integral, sum_v = 0.0;
    for (int i = 1; i <= k; ++i) {
      sum_p += ep[static_cast<std::size_t>(i)] * 0.1;
      sum_v += ev[static_cast<std::size_t>(i)] * 0.1;
    }
    // Sums of 300 terms of order 1 in the same order: equal to some roundings of a value up to 10.
    EXPECT_NEAR(pi.update(ep.back(), ev.back()),
                2.0 * ep.back() + 0.5 * sum_p + 3.0 * ev.back() + 0.25 * sum_v, 1e-13);
  }
}

TEST(PiController, InitialEffortIsTheFirstOutput) {
  PiController pi(kGains, 0.1, {-kInf, kInf});
  pi.reset(-0.7);
  EXPECT_DOUBLE_EQ(pi.update(0.0, 0.0), -0.7);
  EXPECT_DOUBLE_EQ(pi.update(0.0, 0.0), -0.7);
  PiController velocity_only({1.0, 0.0, 1.0, 0.5}, 0.1, {-kInf, kInf});
  velocity_only.reset(0.3);
  EXPECT_DOUBLE_EQ(velocity_only.update(0.0, 0.0), 0.3);
  PiController without({1.0, 0.0, 1.0, 0.0}, 0.1, {-kInf, kInf});
  EXPECT_NO_THROW(without.reset(0.0));
  EXPECT_THROW(without.reset(0.3), quad_support::ConfigError);
}

TEST(PiController, SaturatesAndLeavesSaturationAtOnce) {
  PiController pi({1.0, 1.0, 0.0, 0.0}, 0.1, {-0.5, 2.0});
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(pi.update(5.0, 0.0), 2.0);
    EXPECT_TRUE(pi.saturated());
  }
  EXPECT_EQ(pi.positionIntegral(), 0.0);  // nothing was summed while at the limit
  EXPECT_EQ(pi.update(0.0, 0.0),
            0.0);  // with wind-up this would still be at 2 for a hundred samples
  EXPECT_FALSE(pi.saturated());
  for (int k = 0; k < 100; ++k) EXPECT_EQ(pi.update(-5.0, 0.0), -0.5);
  EXPECT_EQ(pi.positionIntegral(), 0.0);
}

TEST(PiController, IntegratesBackFromBeyondTheLimit) {
  PiController pi({0.0, 1.0, 0.0, 0.0}, 0.1, {-1.0, 1.0});
  pi.reset(3.0);  // the sum starts beyond the limit
  EXPECT_EQ(pi.update(0.0, 0.0), 1.0);
  EXPECT_EQ(pi.update(1.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(pi.positionIntegral(), 3.0);  // not further out
  EXPECT_EQ(pi.update(-1.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(pi.positionIntegral(), 2.9);  // but back
}

TEST(PiController, AntiWindupIsJudgedForEachIntegral) {
  PiController pi({0.0, 1.0, 0.0, 1.0}, 0.1, {-1.0, 1.0});
  pi.reset(2.0);
  pi.update(0.0, 0.0);
  pi.update(1.0, -1.0);
  EXPECT_DOUBLE_EQ(pi.positionIntegral(), 2.0);
  EXPECT_DOUBLE_EQ(pi.velocityIntegral(), -0.1);
}

TEST(PiController, OutputNeverLeavesTheLimits) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  PiController pi(kGains, 0.1, {-1.0, 4.0});
  for (int k = 0; k < 2000; ++k) {
    const double u = pi.update(3.0 * normal(random), normal(random));
    ASSERT_GE(u, -1.0);
    ASSERT_LE(u, 4.0);
  }
}

TEST(PiController, RefusesNonsense) {
  EXPECT_THROW(PiController({-1.0, 0, 0, 0}, 0.1, {-1, 1}), std::invalid_argument);
  EXPECT_THROW(PiController({kInf, 0, 0, 0}, 0.1, {-1, 1}), std::invalid_argument);
  EXPECT_THROW(PiController(kGains, 0.0, {-1, 1}), std::invalid_argument);
  EXPECT_THROW(PiController(kGains, 0.1, {1, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace quad_control
