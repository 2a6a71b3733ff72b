// RotorS's peculiarities: each switch by itself against a sum by hand, and the whole profile
// against RotorS's order of things written down a second time.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kF = 8.54858e-06;

SimulatorOptions with(const std::vector<std::string>& quirks, double step = 0.01) {
  SimulatorOptions options;
  options.step = step;
  options.ground = false;
  for (const std::string& name : quirks) options.quirks.byName(name) = true;
  return options;
}

VehicleState hovering(const VehicleModel& m) { return equilibrium(m, 9.8, 10); }

/// RotorS and Gazebo in vertical flight, as rotors.md describes their step: forces from the joint's
/// speed, then the motor's filter, then velocity, then position with the new velocity.
struct VerticalRotorS {
  double z = 10, v = 0;
  double output[4] = {0, 0, 0, 0};
  void step(const double* reference, double h) {
    constexpr double kMass = 0.68 + 4 * 0.009 + 0.015 + 3e-5;
    double force = 0;
    for (int i = 0; i < 4; ++i) {
      force += output[i] * output[i] * kF;
      const double tau = reference[i] > output[i] ? 0.0125 : 0.025;
      const double a = std::exp(-h / tau);
      output[i] = a * output[i] + (1 - a) * reference[i];
    }
    v += h * (force / kMass - 9.8);
    z += h * v;
  }
};

TEST(RotorsCompat, FollowsRotorSsOrderInPureThrust) {
  const VehicleModel m = hummingbird();
  SimulatorOptions options;
  options.step = 0.01;
  options.ground = false;
  options.profile = Profile::kRotorsCompat;
  for (const Multibody multibody : {Multibody::kFolded, Multibody::kHinged}) {
    options.multibody = multibody;
    Simulator s(m, options);
    VehicleState start;
    start.p_WB.z() = 10;
    start.rotor_speed.assign(4, 0.0);
    s.setStartState(start);
    VerticalRotorS theirs;
    double worst = 0, lowest = 10, highest = 10;
    for (int k = 0; k < 500; ++k) {
      // Equal speeds: thrust alone. Steps up, down and over the limit.
      const double wanted = k < 100 ? 480 : k < 200 ? 838 : k < 300 ? 250.5 : 458;
      const double command = static_cast<double>(static_cast<float>(wanted));
      s.setCommand({wanted, wanted, wanted, wanted});
      s.advance(1);
      const double reference[4] = {command, command, command, command};
      theirs.step(reference, 0.01);
      worst = std::max(worst, std::abs(s.state().p_WB.z() - theirs.z));
      lowest = std::min(lowest, theirs.z);
      highest = std::max(highest, theirs.z);
      EXPECT_NEAR(s.state().rotor_speed[0], theirs.output[0], 1e-9);
    }
    EXPECT_GT(highest - lowest, 5);
    EXPECT_LT(worst, 1e-6);  // the promise; measured 1e-12
    std::printf("rotors_compat, 5 s at 10 ms: %.1e m off RotorS's order\n", worst);
  }
}

TEST(RotorsCompat, TheDefaultProfileIsNotRotorS) {
  const VehicleModel m = hummingbird();
  Simulator s(m, with({}));
  VehicleState start;
  start.p_WB.z() = 10;
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  VerticalRotorS theirs;
  const double reference[4] = {480, 480, 480, 480};
  s.setCommand({480, 480, 480, 480});
  for (int k = 0; k < 100; ++k) theirs.step(reference, 0.01);
  s.advance(100);
  EXPECT_GT(std::abs(s.state().p_WB.z() - theirs.z), 0.03);  // or the test above could not fail
}

TEST(Quirk, ThrustLag) {
  // Rotors start at zero: no thrust in the first step, then that of the first step's end.
  const VehicleModel m = hummingbird();
  Simulator s(m, with({"thrust_lag"}));
  VehicleState start;
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.setCommand({800, 800, 800, 800});
  s.advance(1);
  EXPECT_NEAR(s.state().v_WB.z(), -0.098, 1e-15);
  const double w = 800 * (1 - std::exp(-0.8));
  EXPECT_NEAR(s.state().rotor_speed[0], w, 1e-10);
  s.advance(1);
  EXPECT_NEAR(s.state().v_WB.z(), -0.196 + 0.01 * 4 * kF * w * w / m.mass, 1e-12);
}

TEST(Quirk, UncheckedCommands) {
  const VehicleModel m = hummingbird();
  Simulator s(m, with({"unchecked_commands"}));
  s.setStartState(hovering(m));
  s.setCommand({-300, 900, 400, 400});
  EXPECT_EQ(s.command(), (std::vector<double>{-300, 838, 400, 400}));  // only the upper limit holds
  EXPECT_EQ(s.commandCounts().clamped, 1);
  s.advance(100);
  EXPECT_NEAR(s.state().rotor_speed[0], -300, 1e-6);
  // Turning backwards it thrusts backwards: alone in the step after, at constant speed.
  VehicleState level = hovering(m);
  level.rotor_speed = s.state().rotor_speed;
  level.rotor_speed[0] = 0;  // states are still checked
  s.setState(level);
  s.setCommand({-300, 0, 0, 0});
  s.advance(200);
  EXPECT_LT(s.state().rotor_speed[0], -299);
  EXPECT_THAT(complaint<quad_support::DataError>([&] {
                s.setCommand({1, 2, 3});
              }),
              HasSubstr("3 rotor speeds"));
  s.setState(hovering(m));
  s.setCommand({std::nan(""), 0, 0, 0});  // reaches the plant, whose end is reported
  EXPECT_THAT(complaint<quad_support::SimulationError>([&] { s.advance(5); }),
              HasSubstr("diverged"));
  Simulator checked(m, with({}));
  EXPECT_THROW(checked.setCommand({std::nan(""), 0, 0, 0}), quad_support::DataError);
}

TEST(Quirk, ABackwardRotorThrustsBackward) {
  const VehicleModel m = hummingbird();
  Simulator s(m, with({"unchecked_commands"}, 0.001));
  VehicleState start;
  start.p_WB.z() = 10;
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.setCommand({-400, -400, -400, -400});
  s.advance(700);  // 28 time constants: the speed has settled to 1e-12
  const double v = s.state().v_WB.z();
  s.advance(1);
  EXPECT_NEAR((s.state().v_WB.z() - v) / 0.001, -9.8 - 4 * kF * 400 * 400 / m.mass, 1e-6);
}

TEST(Quirk, FloatCommands) {
  const VehicleModel m = hummingbird();
  Simulator s(m, with({"float_commands"})), exact(m, with({}));
  const double w = 457.123456789;
  s.setCommand({w, w, w, w});
  exact.setCommand({w, w, w, w});
  EXPECT_EQ(s.command()[0], static_cast<double>(457.123456789F));
  EXPECT_EQ(exact.command()[0], w);
  EXPECT_NE(s.command()[0], w);
}

TEST(Quirk, RollingMomentSign) {
  // Four equal rotors sideways: with the turning direction the moments cancel, without they add up
  // to -4 |w| c v.
  VehicleModel m = hummingbird();
  for (RotorModel& r : m.rotors) r.drag_coefficient = 0;
  const auto rate = [&](const std::vector<std::string>& quirks) {
    Simulator s(m, with(quirks, 1e-4));
    VehicleState start = hovering(m);
    start.v_WB = Vector3d(2, 0, 0);
    s.setStartState(start);
    s.advance(1);
    return s.state().w_WB_B;
  };
  EXPECT_LT(rate({}).norm(), 1e-15);
  const double expected = -4 * hoverSpeed(m, 9.8) * 1e-6 * 2 / m.inertia_B(0, 0) * 1e-4;
  EXPECT_NEAR(rate({"rolling_moment_sign"}).x(), expected, 1e-9 * std::abs(expected));
}

TEST(Quirk, NoSpinReaction) {
  VehicleModel m = hummingbird();
  for (RotorModel& r : m.rotors) {
    r.thrust_coefficient = 1e-30;
    r.drag_coefficient = r.rolling_moment_coefficient = 0;
  }
  for (const Multibody multibody : {Multibody::kFolded, Multibody::kHinged}) {
    const auto yaw = [&](const std::vector<std::string>& quirks) {
      SimulatorOptions options = with(quirks, 0.001);
      options.multibody = multibody;
      Simulator s(m, options);
      s.setCommand({0, 500, 0, 0});
      s.advance(500);
      return s.state().w_WB_B.z();
    };
    // Momentum is kept to rounding in both; what is compared is the body's share alone.
    EXPECT_NEAR(yaw({}), -m.rotors[1].axial_inertia * 500 / m.inertia_B(2, 2), 1e-9);
    EXPECT_NEAR(yaw({"no_spin_reaction"}), 0, 1e-12);
  }
}

TEST(Quirk, UrdfRotorInertia) {
  // The same torque turns a vehicle whose rotors weigh in at ten times their transverse inertia
  // more slowly; about the axis the rotors' inertia counts for nothing.
  VehicleModel m = hummingbird();
  const auto rates = [&](const std::vector<std::string>& quirks) {
    Simulator s(m, with(quirks, 1e-4));
    VehicleState start = hovering(m);
    start.rotor_speed = {450, 460, 440, 450};
    s.setStartState(start);
    s.advance(1);
    return s.state().w_WB_B;
  };
  const Vector3d without = rates({}), with_it = rates({"urdf_rotor_inertia"});
  const double jt = m.rotors[0].transverse_inertia, jz = m.rotors[0].axial_inertia;
  // Gyroscopic torques are second order in the step.
  EXPECT_NEAR(with_it.x() / without.x(), m.inertia_B(0, 0) / (m.inertia_B(0, 0) + 4 * 9 * jt),
              1e-5);
  EXPECT_NEAR(with_it.z() / without.z(), m.inertia_B(2, 2) / (m.inertia_B(2, 2) - 4 * jz), 1e-5);
}

TEST(Quirk, EulerIntegration) {
  // A second of free fall in steps of 10 ms: h g t / 2 too far.
  const VehicleModel m = hummingbird();
  const auto fall = [&](const std::vector<std::string>& quirks) {
    Simulator s(m, with(quirks));
    VehicleState start;
    start.rotor_speed.assign(4, 0.0);
    s.setStartState(start);
    s.advance(100);
    return s.state().p_WB.z();
  };
  EXPECT_NEAR(fall({}), -4.9, 1e-12);
  EXPECT_NEAR(fall({"euler_integration"}), -4.9 - 0.01 * 9.8 / 2, 1e-12);
  // The gyroscopic torque of the start, explicitly: one step from rates about two axes.
  Simulator s(m, with({"euler_integration"}));
  VehicleState start;
  start.w_WB_B = Vector3d(2, 1, 3);
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.advance(1);
  const Vector3d w = start.w_WB_B,
                 expected = w - 0.01 * m.inertia_B.inverse() * w.cross(m.inertia_B * w);
  EXPECT_LT((s.state().w_WB_B - expected).norm(), 1e-12);
}

TEST(Quirk, FilterSurvivesReset) {
  const VehicleModel m = hummingbird();
  Simulator s(m, with({"filter_survives_reset"}));
  s.setStartState(hovering(m));
  s.setCommand({500, 500, 500, 500});
  s.advance(2);
  const double speed = s.state().rotor_speed[0], time = 0.02;
  s.reset();
  EXPECT_EQ(s.state().rotor_speed[0], speed);
  EXPECT_EQ(s.timeNanoseconds(), 0);
  s.setCommand({500, 500, 500, 500});
  s.advance(1);
  // dt = 0.01 - 0.02 < 0: away from the command, by exp(+).
  const double expected = 500 + (speed - 500) * std::exp((time - 0.01) / 0.0125);
  EXPECT_NEAR(s.state().rotor_speed[0], expected, 1e-9);
  Simulator clean(m, with({}));
  clean.setStartState(hovering(m));
  clean.setCommand({500, 500, 500, 500});
  clean.advance(2);
  clean.reset();
  EXPECT_EQ(clean.state().rotor_speed[0], hovering(m).rotor_speed[0]);
}

TEST(Quirk, WorldResetKeepsRotors) {
  const VehicleModel m = hummingbird();
  for (const bool quirk : {true, false}) {
    Simulator s(m, with(quirk ? std::vector<std::string>{"world_reset_keeps_rotors"}
                              : std::vector<std::string>{}));
    s.setStartState(hovering(m));
    s.setCommand({500, 510, 520, 530});
    s.advance(20);
    const std::vector<double> speeds = s.state().rotor_speed;
    s.resetWorld();
    EXPECT_EQ(s.state().p_WB.z(), 10);
    EXPECT_EQ(s.timeNanoseconds(), 200000000);
    EXPECT_EQ(s.state().rotor_speed, quirk ? speeds : hovering(m).rotor_speed);
    EXPECT_EQ(s.command(),
              quirk ? (std::vector<double>{500, 510, 520, 530}) : hovering(m).rotor_speed);
  }
}

TEST(Quirk, StampAhead) {
  const VehicleModel m = hummingbird();
  Simulator s(m, with({"stamp_ahead"}));
  s.advance(3);
  EXPECT_EQ(s.measure().odometry.time_ns, 40000000);
  EXPECT_EQ(s.timeNanoseconds(), 30000000);
}

TEST(Quirk, AliasingBlind) {
  // 838 rad/s in steps of 10 ms: 8.4 rad a step. RotorS looks at a tenth of it, with its sign.
  const VehicleModel m = hummingbird();
  const auto aliased = [&](const std::vector<std::string>& quirks, double step) {
    Simulator s(m, with(quirks, step));
    s.setStartState(hovering(m));
    s.setCommand({838, 838, 838, 838});
    s.advance(static_cast<int>(std::lround(0.4 / step)));
    return s.aliasedRotors();
  };
  EXPECT_EQ(aliased({}, 0.01), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(aliased({}, 0.001), std::vector<int>{});
  EXPECT_EQ(aliased({"aliasing_blind"}, 0.01), std::vector<int>{});
  EXPECT_EQ(aliased({"aliasing_blind"}, 0.04),
            (std::vector<int>{1, 3}));  // never the clockwise ones
}

}  // namespace
}  // namespace quad_sim
