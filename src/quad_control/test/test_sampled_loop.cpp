#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "hummingbird.hpp"
#include "quad_control/control_config.hpp"
#include "sampled_loop.hpp"

namespace quad_control {
namespace {

constexpr double kPeriodSeconds = 0.1;
const std::vector<double> kLatencies = {0.0, 0.045}, kLags = {0.0125, 0.025};
const std::vector<double> kClimbRates = {0.0, -10.0, -20.0, -30.0, -40.0, -52.0};
const std::vector<double> kRotorSpeeds = {240.0, 423.0, 540.0};  // 2, 6.1 and 10 N

ControlConfig shipped() {
  const auto in = quad_support::ConfigReader::fromFile("../../config/thesis.yaml");
  return readControlConfig(in.section("control"), kPeriodSeconds);
}

struct Worst {
  double radius = 0.0, gain_up = 1e9, gain_down = 0.0, phase = 1e9, delay = 1e9, peak = 0.0;

  void include(const LinearPlant& plant, const PiGains& gains) {
    const std::vector<PiGains> all(plant.position.size(), gains);
    for (const double latency : kLatencies) {
      const SampledPlant sampled = discretise(plant, kPeriodSeconds, latency);
      radius = std::max(radius, spectralRadius(closedLoop(plant, sampled, all)));
      const LoopMargins m = margins(plant, sampled, all, 0);
      gain_up = std::min(gain_up, m.gain_up);
      gain_down = std::max(gain_down, m.gain_down);
      phase = std::min(phase, m.phase_degrees);
      delay = std::min(delay, m.delay_s);
      peak = std::max(peak, m.sensitivity_peak);
    }
  }
  void print(const char* name) const {
    std::cout << std::setprecision(4) << name << ": spectral radius " << radius << ", gain x "
              << gain_down << " ... x " << gain_up << ", phase " << phase << " deg, delay "
              << 1e3 * delay << " ms, peak " << peak << '\n';
  }
};

TEST(Discretise, DoubleIntegratorIsEq22) {
  // Without rotor lag and latency: A = [1 dT; 0 1], B = [dT²/2; dT] / m, thesis Eq. (2.2).
  LinearPlant plant{Eigen::Matrix2d{{0, 1}, {0, 0}}, Eigen::Vector2d(0, 1 / 0.73), {0}, {1}};
  const SampledPlant sampled = discretise(plant, kPeriodSeconds, 0.0);
  EXPECT_LE((sampled.A - Eigen::Matrix2d{{1, 0.1}, {0, 1}}).norm(), 1e-15);
  EXPECT_LE((sampled.B_new - Eigen::Vector2d(0.005, 0.1) / 0.73).norm(), 1e-15);
  EXPECT_EQ(sampled.B_old.norm(), 0.0);
  // With latency d the old input pushes first: velocity d/m, position (d²/2 + d (dT − d))/m.
  const SampledPlant late = discretise(plant, kPeriodSeconds, 0.045);
  EXPECT_LE((late.B_old - Eigen::Vector2d(0.045 * 0.045 / 2 + 0.045 * 0.055, 0.045) / 0.73).norm(),
            1e-15);
  EXPECT_LE((late.B_old + late.B_new - sampled.B_new).norm(), 1e-15);
  EXPECT_THROW(discretise(plant, kPeriodSeconds, -0.001), std::invalid_argument);
  EXPECT_THROW(discretise(plant, 0.0, 0.0), std::invalid_argument);
}

TEST(ClosedLoop, FollowsThePiController) {
  // The matrix against the law itself, stepped: two implementations, one motion.
  const PiGains gains{2.4, 0.6, 2.4, 0.6};
  const LinearPlant plant = doubleIntegratorPlant(0.73, 0.0125);
  const SampledPlant sampled = discretise(plant, kPeriodSeconds, 0.045);
  const Eigen::MatrixXd closed = closedLoop(plant, sampled, {gains});
  PiController pi(gains, kPeriodSeconds, {-1e9, 1e9});
  Eigen::Vector3d x(1.0, -0.5, 0.0);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(5);
  state.head(3) = x;
  // The matrix has summed sample 0 already, the law has not: start its sum one sample short.
  state(3) = -kPeriodSeconds * (gains.position_integral * x(0) + gains.velocity_integral * x(1));
  double u_last = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double u = pi.update(-x(0), -x(1));
    x = sampled.A * x + sampled.B_old * u_last + sampled.B_new * u;
    u_last = u;
    state = closed * state;
    ASSERT_LE((state.head(3) - x).norm(), 1e-12)
        << k;  // values up to 1, a decaying motion: rounding only
  }
}

TEST(SpectralRadius, KnowsAnUnstableLoop) {
  const LinearPlant plant = doubleIntegratorPlant(0.73, 0.0125);
  const SampledPlant sampled = discretise(plant, kPeriodSeconds, 0.045);
  EXPECT_GT(spectralRadius(closedLoop(plant, sampled, {{2.4, 0.6, 20.0, 0.0}})), 1.0);
  EXPECT_THROW(margins(plant, sampled, {{2.4, 0.6, 20.0, 0.0}}, 0), std::invalid_argument);
}

TEST(Margins, AgreeWithTheFrequencyResponse) {
  // The margins found by eigenvalues against those the phase and the peak of the response promise.
  const PiGains gains{2.4, 0.7, 2.4, 0.6};
  const LinearPlant plant = doubleIntegratorPlant(0.73, 0.0125);
  const LoopMargins m = margins(plant, discretise(plant, kPeriodSeconds, 0.045), {gains}, 0);
  const double peak = m.sensitivity_peak;
  EXPECT_GE(m.gain_up, peak / (peak - 1));
  EXPECT_LE(m.gain_down, peak / (peak + 1));
  EXPECT_GE(m.phase_degrees, 2 * std::asin(0.5 / peak) * 180 / M_PI);
  // At the delay margin's edge the loop oscillates undamped.
  const auto radius = [&](double more) {
    return spectralRadius(
        closedLoop(plant, discretise(plant, kPeriodSeconds, 0.045 + more), {gains}));
  };
  EXPECT_NEAR(radius(m.delay_s), 1.0, 1e-6);
  EXPECT_LT(radius(0.99 * m.delay_s), 1.0);
  EXPECT_GT(radius(1.01 * m.delay_s), 1.0);
}

TEST(ClosedLoop, LatencyBeyondAPeriodFollowsTheStepwiseLoop) {
  const PiGains gains{2.0, 0.0, 1.5, 0.0};
  const LinearPlant plant = doubleIntegratorPlant(0.73, 0.025);
  const SampledPlant sampled = discretise(plant, kPeriodSeconds, 0.23);
  ASSERT_EQ(sampled.whole_periods, 2);
  const Eigen::MatrixXd closed = closedLoop(plant, sampled, {gains});
  Eigen::Vector3d x(1.0, 0.0, 0.0);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(6);
  state.head(3) = x;
  std::vector<double> u(3, 0.0);  // u[k-3], u[k-2], u[k-1]
  for (int k = 0; k < 60; ++k) {
    u.push_back(-gains.position * x(0) - gains.velocity * x(1));
    const std::size_t now = u.size() - 1;
    x = sampled.A * x + sampled.B_old * u[now - 3] + sampled.B_new * u[now - 2];
    state = closed * state;
    ASSERT_LE((state.head(3) - x).norm(), 1e-12 * (1.0 + x.norm()))
        << k;  // the same sums in another order
  }
}

TEST(ShippedGains, RollAndPitchAtAnyFallSpeed) {
  Worst all;
  for (const double climb : kClimbRates) {
    Worst worst;
    for (const double speed : kRotorSpeeds) {
      for (const double lag : kLags) {
        const LinearPlant plant = tiltPlant(test::hummingbirdLoops(), climb, speed, lag);
        worst.include(plant, shipped().roll_pitch);
        all.include(plant, shipped().roll_pitch);
      }
    }
    std::cout << climb << " m/s  ";
    worst.print("roll/pitch");
  }
  // The slowest eigenvalue is the horizontal speed's and the integral's (seconds), not the tilt's.
  EXPECT_LT(all.radius, 0.997);
  EXPECT_GT(all.gain_up, 2.2);
  EXPECT_LT(all.gain_down, 0.5);
  EXPECT_GT(all.phase, 30.0);
  EXPECT_GT(all.delay, 0.045);  // the latency may double
  EXPECT_LT(all.peak, 1.9);     // guarantees gain x 2.1 and 30 degrees
}

TEST(ShippedGains, RollAndPitchWithRollingMomentsThatAdd) {
  // Profile rotors_compat: the moments couple roll and pitch like a gyroscope without the
  // gyroscope's energy balance.
  Worst all;
  for (const double climb : kClimbRates) {
    for (const double speed : kRotorSpeeds) {
      for (const double lag : kLags) {
        all.include(tiltPlant(test::hummingbirdLoops(), climb, speed, lag, true),
                    shipped().roll_pitch);
      }
    }
  }
  all.print("roll/pitch, rotors_compat");
  EXPECT_LT(all.radius, 1.0);
}

TEST(ShippedGains, Yaw) {
  Worst worst;
  for (const double lag : kLags) worst.include(doubleIntegratorPlant(0.0131, lag), shipped().yaw);
  worst.print("yaw");
  EXPECT_LT(worst.radius, 0.99);
  EXPECT_GT(worst.gain_up, 2.5);
  EXPECT_GT(worst.phase, 35.0);
  EXPECT_GT(worst.delay, 0.1);
  EXPECT_LT(worst.peak, 1.6);
}

TEST(ShippedGains, Altitude) {
  Worst worst;
  for (const double lag : kLags)
    worst.include(doubleIntegratorPlant(0.73, lag), shipped().altitude);
  worst.print("altitude");
  EXPECT_LT(worst.radius, 0.99);
  EXPECT_GT(worst.gain_up, 2.5);
  EXPECT_GT(worst.phase, 35.0);
  EXPECT_GT(worst.delay, 0.1);
  EXPECT_LT(worst.peak, 1.6);
}

TEST(TiltPlant, PendulumStiffnessByHand) {
  // h c |ż| / I: 0.009508 m * 4 * 423 * 8.06428e-5 * 52 / 0.0077 = 8.76 1/s².
  const LinearPlant plant = tiltPlant(test::hummingbirdLoops(), -52.0, 423.0, 0.0125);
  EXPECT_NEAR(plant.A(2, 1), -8.76, 0.005);  // printed to two decimals
}

}  // namespace
}  // namespace quad_control
