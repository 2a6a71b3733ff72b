// Waypoints in time, their file, and the samples a controller answers.
#include <gmock/gmock.h>

#include <cmath>

#include "quad_control/references.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

using testing::HasSubstr;
constexpr std::int64_t kSecond = 1000000000;

TEST(ReferenceTrajectory, EachWaypointIsInForceFromItsTimeOn) {
  ReferenceTrajectory t({{kSecond, {1, 0, 0, 0}}, {3 * kSecond, {2, 0, 0, 0}}});
  EXPECT_FALSE(t.at(10 * kSecond)) << "time begins here";
  EXPECT_FALSE(t.at(11 * kSecond - 1));
  EXPECT_EQ(t.at(11 * kSecond)->x, 1);
  EXPECT_EQ(t.at(13 * kSecond - 1)->x, 1);
  EXPECT_FALSE(t.isFinished(13 * kSecond - 1));
  EXPECT_EQ(t.at(13 * kSecond)->x, 2);
  EXPECT_TRUE(t.isFinished(13 * kSecond));
  EXPECT_FALSE(t.at(0)) << "the simulation was reset";
  EXPECT_EQ(t.at(kSecond)->x, 1);
}

template <class Action>
std::string complaint(const Action& action) {
  try {
    action();
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

TEST(ReferenceTrajectory, ImpossibleOnesAreRefused) {
  EXPECT_THAT(complaint([] { ReferenceTrajectory t(std::vector<Waypoint>{}); }),
              HasSubstr("no waypoint"));
  EXPECT_THAT(complaint([] {
                ReferenceTrajectory t(std::vector<Waypoint>{{2, {}}, {1, {}}});
              }),
              HasSubstr("waypoint 1: time"));
  EXPECT_THAT(complaint([] {
                ReferenceTrajectory t(std::vector<Waypoint>{{0, {0, 0, NAN, 0}}});
              }),
              HasSubstr("is not finite"));
}

TEST(Waypoints, AreReadAsRotorsWritesThem) {
  const auto w = readWaypoints("# start\n0 0 0 1 0\n\n2.5 1 0.5 1.5 90 # turned\n", "w.txt");
  ASSERT_EQ(w.size(), 2U);
  EXPECT_EQ(w[1].from_start_ns, 2500000000);
  EXPECT_EQ(w[1].references.y, 0.5);
  EXPECT_NEAR(w[1].references.yaw, std::acos(0.0), 1e-15);
  EXPECT_THAT(complaint([] { readWaypoints("0 0 0 1 0\n1 2 3\n", "w.txt"); }),
              HasSubstr("w.txt:2: 3 numbers; must be 5"));
  EXPECT_THAT(complaint([] { readWaypoints("0 0 up 1 0\n", "w.txt"); }),
              HasSubstr("w.txt:1: 'up' is not a number"));
  EXPECT_THAT(complaint([] { readWaypoints("-1 0 0 1 0\n", "w.txt"); }),
              HasSubstr("must lie in [0, 1e6]"));
  EXPECT_THAT(complaint([] { readWaypoints("# nothing\n", "w.txt"); }),
              HasSubstr("w.txt: no waypoint"));
}

int samplesIn(double odometry_ms, double period_s, double seconds) {
  SampleClock clock(period_s);
  int samples = 0;
  for (double t = 0; t < seconds * 1000; t += odometry_ms)
    samples += clock.isSample(std::llround(t * 1e6)) ? 1 : 0;
  return samples;
}

TEST(SampleClock, SamplesAreAPeriodApartHoweverFastTheOdometryIs) {
  EXPECT_EQ(samplesIn(10, 0.1, 10), 100);
  EXPECT_EQ(samplesIn(1, 0.1, 10), 100);
  EXPECT_EQ(samplesIn(100, 0.1, 10), 100);
  EXPECT_EQ(samplesIn(40, 0.1, 10), 125) << "80 ms is within half an interval of 100";
  EXPECT_EQ(samplesIn(200, 0.1, 10), 50) << "slower odometry: what there is";
}

TEST(SampleClock, JitterTakesNoSampleAwayAndResetBeginsAnew) {
  SampleClock clock(0.1);
  std::int64_t t = 0;
  for (const int ms : {95, 108, 90, 83, 104, 99}) {
    EXPECT_TRUE(clock.isSample(t));
    t += ms * 1000000;
  }
  EXPECT_TRUE(clock.isSample(t));
  EXPECT_FALSE(clock.isSample(t + 10000000));
  EXPECT_TRUE(clock.isSample(0));
  EXPECT_FALSE(clock.isSample(10000000));
}

}  // namespace
}  // namespace quad_control
