#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "quad_experiment/flight.hpp"
#include "quad_experiment/verdicts.hpp"
#include "quad_support/errors.hpp"

using namespace quad_experiment;

namespace {

constexpr std::int64_t kMillisecond = 1000000;

/// Moves up by a metre a second; answers with its time as thrust. What a plant does is not the
/// loop's business.
class FakePlant : public Plant {
 public:
  quad_sim::Measurement begin(const quad_control::FlightPlan&) override {
    now_ = {};
    now_.odometry.p_WB.z() = 100.0;
    now_.rotor_speed = {1, 2, 3, 4};
    return now_;
  }
  quad_sim::Measurement advance(const Interval& interval) override {
    quad_control::ControlOutput command;
    command.time_ns = now_.odometry.time_ns;
    command.thrust = static_cast<double>(command.time_ns);
    commands_.push_back(command);
    now_.odometry.time_ns += interval.steps * kMillisecond;
    now_.odometry.p_WB.z() += z_per_interval;
    if (now_.odometry.time_ns == lost_at_ns) now_.odometry.p_WB.x() = lost_at;
    if (contact_ns >= 0 && now_.odometry.time_ns > contact_ns) now_.ground_contact_ns = contact_ns;
    return now_;
  }
  std::vector<quad_control::ControlOutput> end() override { return commands_; }

  double z_per_interval = 0.1;
  std::int64_t lost_at_ns = -1, contact_ns = -1;
  double lost_at = 0.0;
  std::vector<quad_control::ControlOutput> commands_;
  quad_sim::Measurement now_;
};

FlightSpec spec(std::size_t samples) {
  FlightSpec spec;
  spec.plan.exploration_signal.assign(samples, 1.0);
  spec.plan.exploration_start_ns = 500 * kMillisecond;
  return spec;
}

const Middleware kExact({0.1, 0.0, 0.0, 0.001}, 1, 0);

}  // namespace

TEST(Fly, HoldsThenExploresAllSamplesAndOneMoreState) {
  FakePlant plant;
  const Trajectory trajectory = fly(plant, spec(7), kExact);
  ASSERT_EQ(trajectory.rows.size(), 5u + 8u);
  EXPECT_EQ(trajectory.firstExplored(), 5u);
  EXPECT_TRUE(trajectory.rows.back().last);
  EXPECT_FALSE(trajectory.rows[11].last);
  for (std::size_t i = 0; i + 1 < trajectory.rows.size(); ++i) {
    EXPECT_EQ(trajectory.rows[i].command.thrust,
              static_cast<double>(trajectory.rows[i].state.odometry.time_ns));
    EXPECT_EQ(trajectory.rows[i].next_time_ns, trajectory.rows[i + 1].state.odometry.time_ns);
  }
}

TEST(Fly, WithoutSignalItEndsAfterTheHold) {
  FakePlant plant;
  FlightSpec hold = spec(0);
  hold.end_of_hold = 2.0;
  const Trajectory trajectory = fly(plant, hold, kExact);
  EXPECT_EQ(trajectory.rows.size(), 21u);
  EXPECT_EQ(trajectory.firstExplored(), 21u);
}

TEST(Fly, TimingFileHasARowAnInterval) {
  FakePlant plant;
  const Trajectory trajectory = fly(plant, spec(2), kExact);
  std::vector<IntervalTiming> timing(7, {0.08, 0.02, 0.015});
  const std::string csv = timingCsv(trajectory, timing);
  EXPECT_EQ(
      csv.rfind("k,t,dT,dT_ctrl,service_delay,estimated_delay\n-5,0,0.1,0.08,0.02,0.015\n", 0), 0u)
      << csv;
  EXPECT_NE(csv.find("\n1,0.6,0.1,0.08,0.02,0.015\n"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 8);
  timing.pop_back();
  EXPECT_THROW(timingCsv(trajectory, timing), std::invalid_argument);
}

TEST(Fly, DelaysAreJudged) {
  EXPECT_FALSE(judgeDelay({}));
  const auto delay = judgeDelay({{0.1, 0.01, 0.01}, {0.09, 0.03, 0.02}, {0.0, 0.02, 0.02}});
  ASSERT_TRUE(delay);
  EXPECT_NEAR(delay->mean, 0.02, 1e-15);
  EXPECT_NEAR(delay->std, 0.01, 1e-15);  // of n - 1
  EXPECT_EQ(delay->estimated, 0.02);
  EXPECT_EQ(delay->without_wait, 1);
}

TEST(Fly, GroundAndDivergenceEndTheFlight) {
  // Between two samples, which both lie above the ground.
  FakePlant bouncing;
  bouncing.contact_ns = 250 * kMillisecond;
  EXPECT_THROW(fly(bouncing, spec(7), kExact), GroundContact);
  for (const double place : {std::numeric_limits<double>::quiet_NaN(), 1e168}) {
    FakePlant diverging;
    diverging.lost_at_ns = 300 * kMillisecond;
    diverging.lost_at = place;
    EXPECT_THROW(fly(diverging, spec(7), kExact), quad_support::SimulationError) << place;
  }
}

TEST(Fly, AMissingCommandIsAnError) {
  class Forgetful : public FakePlant {
    std::vector<quad_control::ControlOutput> end() override { return {}; }
  };
  Forgetful plant;
  EXPECT_THROW(fly(plant, spec(7), kExact), quad_support::EnvironmentError);
}
