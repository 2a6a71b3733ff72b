// When pushes begin and end.
#include <gtest/gtest.h>

#include <limits>

#include "hummingbird.hpp"
#include "odometry_topics.hpp"
#include "pushes.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;

constexpr std::int64_t kMillisecond = 1000000;

Push along(double x, std::int64_t start_ms, std::int64_t end_ms) {
  return {{Vector3d(x, 0, 0), Vector3d::Zero()}, start_ms * kMillisecond, end_ms * kMillisecond};
}

struct Flight {
  Flight() : simulator(hummingbird(), {}), pushes(simulator) {
    VehicleState start;
    start.p_WB.z() = 100;
    start.rotor_speed.assign(4, 0.0);
    simulator.setStartState(start);
  }
  void advanceTo(std::int64_t step) {
    while (simulator.stepCount() < step) {
      const std::int64_t event = pushes.nextEvent();
      const std::int64_t to = std::min(step, event);
      simulator.advance(static_cast<int>(to - simulator.stepCount()));
      if (event == to) pushes.apply();
    }
  }
  double impulse() const { return simulator.model().mass * simulator.state().v_WB.x(); }
  Simulator simulator;
  Pushes pushes;
};

TEST(Pushes, OverlapAndEnd) {
  Flight f;
  f.pushes.add(along(1, 0, 50));
  f.pushes.add(along(2, 20, 30));
  f.pushes.add(along(4, 200, 300));
  EXPECT_EQ(f.pushes.nextEvent(), 20);
  f.advanceTo(100);
  EXPECT_NEAR(f.impulse(), 1 * 0.05 + 2 * 0.01, 1e-12);
  EXPECT_EQ(f.pushes.nextEvent(), 200);
  f.advanceTo(400);
  EXPECT_NEAR(f.impulse(), 0.07 + 0.4, 1e-12);
  EXPECT_EQ(f.pushes.nextEvent(), OdometryTopics::kNever);
}

TEST(Pushes, BetweenTwoStepsBeginAtTheNext) {
  Flight f;
  f.pushes.add(
      {{Vector3d(1, 0, 0), Vector3d::Zero()}, 10 * kMillisecond + 1, 12 * kMillisecond + 1});
  f.advanceTo(50);
  EXPECT_NEAR(f.impulse(), 0.002, 1e-12);  // steps 11 and 12
}

TEST(Pushes, AreArchived) {
  Flight f, twin;
  f.pushes.add(along(1, 0, 50));
  f.pushes.add(along(2, 20, 60));
  f.advanceTo(10);
  StateArchive out;
  f.pushes.archive(out);
  StateArchive in(out.numbers());
  twin.simulator.restore(f.simulator.save());
  twin.pushes.archive(in);
  f.advanceTo(100);
  twin.advanceTo(100);
  EXPECT_EQ(toText(twin.simulator.save()), toText(f.simulator.save()));
}

TEST(Pushes, MustBeNumbers) {
  Flight f;
  Push push = along(1, 0, 50);
  push.wrench.torque.z() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(f.pushes.add(push), std::invalid_argument);
  EXPECT_EQ(f.pushes.nextEvent(), OdometryTopics::kNever);
}

}  // namespace
}  // namespace quad_sim
