// The simulator as a whole: reset, repetition, other worlds beside it, and what it does not take.
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "hummingbird.hpp"
#include "in_the_air.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

/// Bits of a state, for comparison without tolerance.
std::vector<double> numbers(const VehicleState& s) {
  std::vector<double> all = {s.p_WB.x(),   s.p_WB.y(),   s.p_WB.z(),  s.q_WB.w(), s.q_WB.x(),
                             s.q_WB.y(),   s.q_WB.z(),   s.v_WB.x(),  s.v_WB.y(), s.v_WB.z(),
                             s.w_WB_B.x(), s.w_WB_B.y(), s.w_WB_B.z()};
  all.insert(all.end(), s.rotor_speed.begin(), s.rotor_speed.end());
  return all;
}
bool sameBits(const VehicleState& a, const VehicleState& b) {
  const std::vector<double> x = numbers(a), y = numbers(b);
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

void flyRoughly(Simulator& s, int intervals) {
  for (int i = 0; i < intervals; ++i) {
    const double a = 40.0 * std::sin(0.7 * i), b = 25.0 * std::cos(1.3 * i);
    s.setCommand({460 + a, 455 - b, 450 + b, 465 - a});
    s.advance(50);
  }
}

TEST(Simulator, ResetGivesTheSameBits) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  s.setStartState(equilibrium(m, 9.8, 10));
  flyRoughly(s, 40);
  const VehicleState first = s.state();
  EXPECT_GT(first.w_WB_B.norm(), 0.1) << "a flight that does nothing shows nothing";
  s.reset();
  EXPECT_EQ(s.timeNanoseconds(), 0);
  EXPECT_EQ(s.command(), equilibrium(m, 9.8, 10).rotor_speed);
  flyRoughly(s, 40);
  EXPECT_TRUE(sameBits(s.state(), first));
  Simulator fresh(m, SimulatorOptions{});
  fresh.setStartState(equilibrium(m, 9.8, 10));
  flyRoughly(fresh, 40);
  EXPECT_TRUE(sameBits(fresh.state(), first));
}

TEST(Simulator, HowAFlightIsCutIntoAdvancesDoesNotMatter) {
  const VehicleModel m = hummingbird();
  Simulator a(m, inTheAir()), b(m, inTheAir());
  a.setCommand({500, 510, 520, 505});
  b.setCommand({500, 510, 520, 505});
  a.advance(1000);
  for (int i = 0; i < 1000; ++i) b.advance(1);
  EXPECT_TRUE(sameBits(a.state(), b.state()));
}

TEST(Simulator, WorldsDoNotDisturbEachOther) {
  // Both on the ground, where ODE draws random numbers from a generator of the process.
  const VehicleModel m = hummingbird();
  VehicleState tilted;
  tilted.p_WB.z() = 0.2;
  tilted.q_WB = Eigen::AngleAxisd(0.6, Vector3d(1, 0.5, 0).normalized());
  tilted.rotor_speed.assign(4, 0.0);
  Simulator alone(m, SimulatorOptions{}), a(m, SimulatorOptions{}), b(m, SimulatorOptions{});
  for (Simulator* s : {&alone, &a, &b}) s->setStartState(tilted);
  alone.advance(600);
  for (int i = 0; i < 600; ++i) {
    a.advance(1);
    b.advance(1);
  }
  EXPECT_TRUE(alone.groundContact());
  EXPECT_TRUE(sameBits(alone.state(), a.state()));
  EXPECT_TRUE(sameBits(alone.state(), b.state()));
}

TEST(Simulator, WorldsInThreadsOfTheirOwnDoNotDisturbEachOtherEither) {
  const VehicleModel m = hummingbird();
  VehicleState tilted;
  tilted.p_WB.z() = 0.2;
  tilted.q_WB = Eigen::AngleAxisd(0.6, Vector3d(1, 0.5, 0).normalized());
  tilted.rotor_speed.assign(4, 0.0);
  constexpr int kSteps = 3000;  // most of them in contact, so that the threads meet there
  Simulator alone(m, SimulatorOptions{}), a(m, SimulatorOptions{}), b(m, SimulatorOptions{});
  for (Simulator* s : {&alone, &a, &b}) s->setStartState(tilted);
  alone.advance(kSteps);
  std::thread other([&] { a.advance(kSteps); });
  b.advance(kSteps);
  other.join();
  EXPECT_TRUE(sameBits(alone.state(), a.state()));
  EXPECT_TRUE(sameBits(alone.state(), b.state()));
}

TEST(Simulator, ResetWorldKeepsTheTime) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  s.setStartState(equilibrium(m, 9.8, 10));
  flyRoughly(s, 4);
  s.resetWorld();
  EXPECT_EQ(s.timeNanoseconds(), 200000000);
  EXPECT_EQ(s.state().p_WB.z(), 10);
  EXPECT_EQ(s.command(), equilibrium(m, 9.8, 10).rotor_speed);
}

TEST(Simulator, CommandsAreChecked) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  const double nan = std::nan("");
  s.setCommand({100, 200, 300, 400});
  EXPECT_THAT(complaint<quad_support::DataError>([&] {
                s.setCommand({1, 2, 3});
              }),
              HasSubstr("3 rotor speeds; the vehicle has 4"));
  EXPECT_THAT(complaint<quad_support::DataError>([&] {
                s.setCommand({1, 2, 3, nan});
              }),
              HasSubstr("not a finite number"));
  EXPECT_EQ(s.command(), (std::vector<double>{100, 200, 300, 400}));
  s.setCommand({-5, 900, 838, 0});
  EXPECT_EQ(s.command(), (std::vector<double>{0, 838, 838, 0}));
  EXPECT_EQ(s.commandCounts().accepted, 2);
  EXPECT_EQ(s.commandCounts().clamped, 1);
  EXPECT_EQ(s.commandCounts().refused, 2);
}

TEST(Simulator, OptionsAreChecked) {
  const VehicleModel m = hummingbird();
  const auto says = [&](auto change) {
    SimulatorOptions options;
    change(options);
    return complaint<std::invalid_argument>([&] { Simulator(m, options); });
  };
  EXPECT_THAT(says([](auto& o) { o.step = 1e-10; }), HasSubstr("whole number of nanoseconds"));
  EXPECT_THAT(says([](auto& o) { o.step = 0; }), HasSubstr("simulation.step = 0 s"));
  EXPECT_THAT(says([](auto& o) { o.step = std::nan(""); }), HasSubstr("simulation.step"));
  EXPECT_THAT(says([](auto& o) { o.gravity = -1; }), HasSubstr("simulation.gravity = -1"));
}

TEST(Simulator, StatesAreChecked) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  const auto says = [&](auto change) {
    VehicleState state = equilibrium(m, 9.8, 1);
    change(state);
    return complaint<std::invalid_argument>([&] { s.setState(state); });
  };
  EXPECT_THAT(says([](auto& x) { x.p_WB.x() = std::nan(""); }), HasSubstr("finite"));
  EXPECT_THAT(says([](auto& x) { x.q_WB.coeffs().setZero(); }), HasSubstr("quaternion"));
  EXPECT_THAT(says([](auto& x) { x.rotor_speed.pop_back(); }), HasSubstr("3 rotor speeds"));
  EXPECT_THAT(says([](auto& x) { x.rotor_speed[2] = 839; }), HasSubstr("rotor_speed[2] = 839"));
}

TEST(Simulator, AStateThatIsNoLongerFiniteIsAnError) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  VehicleState wild = equilibrium(m, 9.8, 1);
  wild.v_WB.z() = 1.7e308;  // doubles end at 1.8e308
  s.setState(wild);
  EXPECT_THAT(complaint<quad_support::SimulationError>([&] { s.advance(2000); }),
              HasSubstr("no longer finite at 2 s"));
  for (double rate : {1e4, 1e200}) {
    wild = equilibrium(m, 9.8, 1);
    wild.w_WB_B.x() = rate;
    s.setState(wild);
    EXPECT_THAT(complaint<quad_support::SimulationError>([&] { s.advance(10); }),
                HasSubstr("more than a radian in a step"));
  }
}

}  // namespace
}  // namespace quad_sim
