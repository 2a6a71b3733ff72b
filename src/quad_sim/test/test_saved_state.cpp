// Save and restore: the same bits afterwards, wherever the state is taken up.
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using testing::HasSubstr;

/// A flight that tilts, falls, and now and then touches the ground.
void flyOn(Simulator& s, int from, int to) {
  for (int i = from; i < to; ++i) {
    const double a = 12.0 * std::sin(0.7 * i), b = 9.0 * std::cos(1.3 * i),
                 lift = i % 40 < 20 ? 455 : 300;
    s.setCommand({lift + a, lift - b, lift + b, lift - a});
    s.advance(37);
  }
}

SimulatorOptions onGround() { return SimulatorOptions(); }

TEST(SavedState, ContinuesBitForBitInAFreshSimulator) {
  const VehicleModel m = hummingbird();
  Simulator through(m, onGround());
  flyOn(through, 0, 60);
  ASSERT_TRUE(through.groundContact());
  const std::string saved = toText(through.save());
  flyOn(through, 60, 160);

  Simulator fresh(m, onGround());
  flyOn(fresh, 0, 7);  // another past: nothing of it may stay
  fresh.restore(savedStateFromText(saved));
  flyOn(fresh, 60, 160);
  EXPECT_EQ(toText(fresh.save()), toText(through.save()));
  EXPECT_EQ(fresh.timeNanoseconds(), through.timeNanoseconds());
  EXPECT_EQ(fresh.groundContactTime(), through.groundContactTime());
  EXPECT_EQ(fresh.commandCounts().accepted, 160);
}

TEST(SavedState, SavingIsExactAndChangesNothing) {
  Simulator a(hummingbird(), onGround()), b(hummingbird(), onGround());
  for (int i = 0; i < 80; ++i) {
    flyOn(a, i, i + 1);
    flyOn(b, i, i + 1);
    b.restore(b.save());
  }
  EXPECT_EQ(toText(a.save()), toText(b.save()));
}

TEST(SavedState, TextThatIsNotAStateIsRefused) {
  const std::string good = toText(Simulator(hummingbird(), onGround()).save());
  const auto message = [](const std::string& text) {
    try {
      savedStateFromText(text);
    } catch (const quad_support::DataError& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message(good), "accepted");
  EXPECT_THAT(message(""), HasSubstr("first line"));
  EXPECT_THAT(message("quad_sim state 1\nof x\n"), HasSubstr("no line 'step"));
  EXPECT_THAT(message("quad_sim state 1\nof x\nstep -1\nnumbers 1\n"),
              HasSubstr("whole number >= 0"));
  EXPECT_THAT(message("quad_sim state 1\nof x\nstep 1\nnumbers 1 nan\n"),
              HasSubstr("'nan' is not a finite number"));
}

TEST(SavedState, FitsOnlyTheSameVehicleAndOptions) {
  Simulator s(hummingbird(), onGround());
  SimulatorOptions other = onGround();
  other.gravity = 9.81;
  const SavedState foreign = Simulator(hummingbird(), other).save();
  try {
    s.restore(foreign);
    FAIL();
  } catch (const quad_support::DataError& e) {
    EXPECT_THAT(e.what(), HasSubstr("gravity 9.81"));
  }
  SavedState cut = s.save();
  cut.numbers.pop_back();
  EXPECT_THROW(s.restore(cut), quad_support::DataError);
}

TEST(Physics, StepAndGravityChangeInFlight) {
  SimulatorOptions options;
  options.ground = false;
  Simulator s(hummingbird(), options);
  VehicleState start = equilibrium(hummingbird(), 9.8, 100);
  start.v_WB.x() = 1;
  s.setStartState(start);
  s.advance(100);
  const VehicleState before = s.state();
  s.setPhysics(0.002, 12.0);
  EXPECT_EQ(s.timeNanoseconds(), 100000000);
  EXPECT_EQ(s.stepCount(), 50);
  EXPECT_EQ(s.state().p_WB, before.p_WB);
  s.advance(50);
  EXPECT_EQ(s.timeNanoseconds(), 200000000);
  // Thrust carries 9.8 m/s², so it falls with 2.2 m/s² for 0.1 s: -0.22 m/s; the rotors' drag moves
  // that by less than 1 %.
  EXPECT_NEAR(s.state().v_WB.z(), -0.22, 0.0022);
  EXPECT_THROW(s.setPhysics(0.003, 9.8), std::invalid_argument) << "0.2 s is no multiple";
  EXPECT_THROW(s.setPhysics(-1, 9.8), std::invalid_argument);
  EXPECT_THROW(s.setPhysics(0.001, -1), std::invalid_argument);
  EXPECT_EQ(s.options().gravity, 12.0) << "a refused change changes nothing";
  s.reset();
  EXPECT_EQ(s.state().p_WB.z(), 100);
  EXPECT_EQ(s.options().gravity, 12.0);
}

}  // namespace
}  // namespace quad_sim
