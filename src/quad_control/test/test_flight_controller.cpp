#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "hummingbird.hpp"
#include "quad_control/flight_controller.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

constexpr double kMass = 0.73, kGravity = 9.8, kEstimate = 0.6247;
constexpr std::int64_t kPeriod = 100'000'000;

ControlConfig config() {
  ControlConfig c;
  c.sampling_period = 0.1;
  c.roll_pitch = {0.035, 0.007, 0.027, 0.0};
  c.yaw = {0.035, 0.008, 0.04, 0.015};
  c.altitude = {2.4, 0.6, 2.4, 0.6};
  return c;
}

FlightPlan plan() {
  FlightPlan p;
  p.references.z = 5.0;
  p.feed_forward_mass = kEstimate;
  p.gravity = kGravity;
  p.initial_altitude_effort = equilibriumEffort(kMass, kEstimate, kGravity);
  return p;
}

quad_sim::Odometry odometry(int k) {
  quad_sim::Odometry o;
  o.time_ns = k * kPeriod;
  o.p_WB.z() = 5.0;
  return o;
}

FlightController begun(const FlightPlan& p = plan()) {
  FlightController controller(test::hummingbirdRotors(), config());
  controller.begin(p);
  return controller;
}

TEST(RollPitchYaw, IsTheInverseOfRzRyRx) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const double roll = 3.1 * unit(random), pitch = 1.5 * unit(random), yaw = 3.1 * unit(random);
    const Eigen::Quaterniond q = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
    const Eigen::Vector3d angles =
        rollPitchYaw(Eigen::Quaterniond(2.0 * q.coeffs()));  // any length
    // asin loses digits near ±90 degrees: eps / cos(1.5) = 14 eps, atan2 there the same again.
    EXPECT_NEAR(angles.x(), roll, 1e-13);
    EXPECT_NEAR(angles.y(), pitch, 1e-13);
    EXPECT_NEAR(angles.z(), yaw, 1e-13);
  }
}

TEST(WrapAngle, StaysWithinHalfATurn) {
  EXPECT_EQ(wrapAngle(0.5), 0.5);
  EXPECT_NEAR(wrapAngle(3.5), 3.5 - 2 * M_PI, 1e-15);
  EXPECT_NEAR(wrapAngle(-3.5), 2 * M_PI - 3.5, 1e-15);
  EXPECT_DOUBLE_EQ(wrapAngle(-M_PI), M_PI);
  EXPECT_DOUBLE_EQ(wrapAngle(M_PI), M_PI);
}

TEST(FlightController, BeginsInEquilibrium) {
  FlightController controller = begun();
  for (int k = 0; k < 60; ++k) {
    const ControlOutput& out = controller.update(odometry(k));
    EXPECT_NEAR(out.thrust, kMass * kGravity, 1e-14);  // a few roundings of 7 N
    EXPECT_EQ(out.tau_phi, 0.0);
    EXPECT_EQ(out.tau_theta, 0.0);
    EXPECT_EQ(out.tau_psi, 0.0);
    EXPECT_EQ(out.clamped, 0);
    EXPECT_FALSE(out.exploring);
    for (const double speed : out.rotor_speed) {
      EXPECT_NEAR(speed, std::sqrt(kMass * kGravity / 4 / test::kThrustCoefficient), 1e-10);
    }
  }
}

TEST(FlightController, SignalReplacesTheAltitudeLoopSampleBySample) {
  FlightPlan p = plan();
  p.exploration_start_ns = 3 * kPeriod - 1;  // the first odometry at or after it is number 3
  p.exploration_signal = {0.1, -0.2, 0.3};
  FlightController controller = begun(p);
  for (int k = 0; k < 8; ++k) {
    quad_sim::Odometry o = odometry(k);
    o.p_WB.z() = k < 3 ? 5.0 : 4.0;  // an error the altitude loop would answer
    const ControlOutput& out = controller.update(o);
    EXPECT_EQ(out.exploring, k >= 3);
    const double expected = k < 3   ? p.initial_altitude_effort
                            : k < 6 ? p.exploration_signal[k - 3]
                                    : 0.0;
    if (k < 3) {
      EXPECT_NEAR(out.t_eff, expected, 1e-15);
    } else {
      EXPECT_EQ(out.t_eff, expected);
    }
    EXPECT_EQ(out.thrust, out.t_eff + kEstimate * kGravity);
  }
  EXPECT_EQ(controller.record().size(), 8u);
}

TEST(FlightController, WithoutSignalTheHoldGoesOnWhateverTheStart) {
  FlightPlan p = plan();
  p.exploration_start_ns = 0;  // as a message leaves it that sets no start
  FlightController controller = begun(p);
  for (int k = 0; k < 5; ++k) {
    const ControlOutput& out = controller.update(odometry(k));
    EXPECT_FALSE(out.exploring);
    EXPECT_NEAR(out.t_eff, p.initial_altitude_effort, 1e-15);
  }
}

TEST(FlightController, TheRecordOfAnEndlessHoldIsBounded) {
  constexpr int kKept = static_cast<int>(FlightController::kKeptAnswers), kUpdates = 5 * kKept / 2;
  FlightController controller = begun();
  std::size_t longest = 0;
  for (int k = 0; k < kUpdates; ++k) {
    EXPECT_EQ(controller.update(odometry(k)).time_ns, k * kPeriod);
    longest = std::max(longest, controller.record().size());
  }
  EXPECT_EQ(longest, 2 * FlightController::kKeptAnswers - 1);
  ASSERT_GE(controller.record().size(), FlightController::kKeptAnswers);
  EXPECT_EQ(controller.record().back().time_ns, (kUpdates - 1) * kPeriod);
  for (std::size_t i = 1; i < controller.record().size(); ++i) {  // nothing lost in between
    ASSERT_EQ(controller.record()[i].time_ns - controller.record()[i - 1].time_ns, kPeriod) << i;
  }
}

TEST(FlightController, TheRecordOfASignalIsWholeHoweverLongTheFlightGoesOn) {
  constexpr int kKept = static_cast<int>(FlightController::kKeptAnswers), kUpdates = 3 * kKept;
  FlightPlan p = plan();
  p.exploration_start_ns = 3 * kPeriod;
  p.exploration_signal = {0.1, -0.2};
  FlightController controller = begun(p);
  for (int k = 0; k < kUpdates; ++k) controller.update(odometry(k));
  ASSERT_EQ(controller.record().size(), 3 + 2 + FlightController::kKeptAnswers);
  EXPECT_EQ(controller.record().front().time_ns, 0);
  EXPECT_EQ(controller.record()[4].t_eff, -0.2);
  EXPECT_EQ(controller.record().back().time_ns, (kUpdates - 1) * kPeriod);
}

TEST(FlightController, TheSameStampGetsTheSameAnswerOnce) {
  FlightPlan p = plan();
  p.exploration_start_ns = 2 * kPeriod;
  p.exploration_signal = {1.0, 2.0};
  FlightController once = begun(p), twice = begun(p);
  for (int k = 0; k < 5; ++k) {
    quad_sim::Odometry o = odometry(k);
    o.p_WB.z() -= 0.1 * k;
    o.w_WB_B.x() = 0.01 * k;
    const ControlOutput a = once.update(o);
    const ControlOutput b = twice.update(o);
    const ControlOutput c = twice.update(o);
    for (const ControlOutput& other : {b, c}) {
      EXPECT_EQ(a.t_eff, other.t_eff);
      EXPECT_EQ(a.tau_phi, other.tau_phi);
      EXPECT_EQ(a.rotor_speed, other.rotor_speed);
    }
  }
  EXPECT_EQ(twice.record().size(), 5u);
}

TEST(FlightController, AnEarlierStampStartsTheFlightAgain) {
  FlightPlan p = plan();
  p.exploration_start_ns = kPeriod;
  p.exploration_signal = {1.0, 2.0, 3.0};
  FlightController controller = begun(p);
  quad_sim::Odometry stale = odometry(430);  // left over from the flight before
  stale.p_WB.z() = -800.0;
  controller.update(stale);
  EXPECT_NEAR(controller.update(odometry(0)).t_eff, p.initial_altitude_effort, 1e-15);
  EXPECT_EQ(controller.update(odometry(1)).t_eff, 1.0);
  EXPECT_EQ(controller.record().size(), 2u);
}

TEST(FlightController, AnswersErrorsWithTheRightSigns) {
  FlightController controller = begun();
  quad_sim::Odometry o = odometry(0);
  o.p_WB.z() = 4.9;
  o.q_WB = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  o.w_WB_B = {0.0, 0.2, -0.3};
  o.v_WB_B = o.q_WB.conjugate() * Eigen::Vector3d(1.0, 2.0, -0.5);
  const ControlOutput& out = controller.update(o);
  const ControlConfig c = config();
  EXPECT_NEAR(out.tau_phi, -c.roll_pitch.position * 0.1, 1e-16);
  EXPECT_NEAR(out.tau_theta, -c.roll_pitch.velocity * 0.2, 1e-16);
  EXPECT_NEAR(out.tau_psi, c.yaw.velocity * 0.3, 1e-16);
  EXPECT_NEAR(
      out.t_eff,
      plan().initial_altitude_effort + c.altitude.position * 0.1 + c.altitude.velocity * 0.5,
      1e-14);
}

TEST(FlightController, HeadingErrorTakesTheShortWay) {
  FlightPlan p = plan();
  p.references.yaw = 3.0;
  FlightController controller = begun(p);
  quad_sim::Odometry o = odometry(0);
  o.q_WB = Eigen::AngleAxisd(-3.0, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(controller.update(o).tau_psi, config().yaw.position * (6.0 - 2 * M_PI), 1e-15);
}

TEST(PositionLoop, TiltsTowardsTheReferenceInAnyHeading) {
  for (const double yaw : {0.0, 0.7, -2.5}) {
    quad_sim::Odometry o = odometry(0);
    o.q_WB = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
    References r;
    r.x = 1.0;
    r.y = -0.5;
    const TiltReference tilt = positionLoop(r, o, kGravity);
    // Small angles: the thrust's direction Rz Ry Rx e_z has the horizontal part Rz (pitch, -roll),
    // Eq. (1.5).
    const Eigen::Vector2d push =
        Eigen::Rotation2Dd(yaw) * Eigen::Vector2d(tilt.pitch, -tilt.roll) * kGravity;
    EXPECT_NEAR(push.x(), 0.09 * 1.0, 1e-15);
    EXPECT_NEAR(push.y(), 0.09 * -0.5, 1e-15);
    o.v_WB_B = o.q_WB.conjugate() * Eigen::Vector3d(0.15, -0.075, 0.0);  // a = 0.09 e - 0.6 v = 0
    EXPECT_NEAR(positionLoop(r, o, kGravity).pitch, 0.0, 1e-16);
    EXPECT_NEAR(positionLoop(r, o, kGravity).roll, 0.0, 1e-16);
    r.x = 1e6;
    EXPECT_LE(std::abs(positionLoop(r, o, kGravity).pitch), 0.15);
  }
}

TEST(FlightController, OutputsSaturateWithinTheRotors) {
  FlightController controller = begun();
  const double feed_forward = kEstimate * kGravity;
  for (const double side : {-1.0, 1.0}) {
    quad_sim::Odometry o = odometry(side < 0 ? 0 : 1);
    o.p_WB.z() = side * 1e6;
    const ControlOutput falling = controller.update(o);
    EXPECT_EQ(falling.t_eff,
              side > 0 ? -feed_forward : controller.mixer().maxThrust() - feed_forward);
  }
  FlightController turning = begun();
  quad_sim::Odometry o = odometry(0);
  o.w_WB_B.y() = 1e6;
  // From the feed-forward thrust one of the pitch rotors stops: l T / 2.
  EXPECT_NEAR(turning.update(o).tau_theta, -test::kArm * feed_forward / 2, 1e-12);
}

TEST(FlightController, ReferencesMoveWithoutRestart) {
  FlightController controller = begun();
  controller.update(odometry(0));
  References moved = plan().references;
  moved.z += 1.0;
  controller.setReferences(moved);
  const ControlOutput& out = controller.update(odometry(1));
  EXPECT_NEAR(out.t_eff, plan().initial_altitude_effort + 2.4 + 0.6 * 0.1, 1e-14);
  EXPECT_EQ(controller.record().size(), 2u);
}

TEST(FlightController, RefusesWhatCannotFly) {
  FlightController controller(test::hummingbirdRotors(), config());
  EXPECT_THROW(controller.update(odometry(0)), std::logic_error);
  const auto refused = [&controller](auto change) {
    FlightPlan p = plan();
    change(p);
    EXPECT_THROW(controller.begin(p), quad_support::ConfigError);
    EXPECT_FALSE(controller.flying());
  };
  refused([](FlightPlan& p) { p.feed_forward_mass = 0.0; });
  refused([](FlightPlan& p) { p.feed_forward_mass = 3.0; });  // 29 N, the rotors give 24
  refused([](FlightPlan& p) { p.gravity = -9.8; });
  refused([](FlightPlan& p) {
    p.exploration_signal = {0.0, std::numeric_limits<double>::quiet_NaN()};
  });
  refused([](FlightPlan& p) { p.references.z = std::numeric_limits<double>::infinity(); });
  controller.begin(plan());
  quad_sim::Odometry o = odometry(0);
  o.v_WB_B.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(controller.update(o), quad_support::SimulationError);
}

}  // namespace
}  // namespace quad_control
