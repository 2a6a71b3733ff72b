#include <gtest/gtest.h>

#include <string>

#include "quad_control/control_config.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

using quad_support::ConfigReader;

const char* const kText = R"(control:
  roll_pitch: [1, 2, 3, 4]
  yaw: [5, 6, 7, 8]
  altitude: [9, 10, 11, 12]
  position_loop: false
  hold_time: 6.0
timing:
  sampling_period: 0.1
  mode: wallclock
  forgetting_factor: 0.94
  latency: 0.045
  jitter_std: 0.0056
)";

ConfigReader reader(const std::string& from = "", const std::string& to = "") {
  std::string text = kText;
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return ConfigReader::fromText(text, "c.yaml");
}

std::string complaint(const std::string& from, const std::string& to) {
  const ConfigReader in = reader(from, to);
  try {
    readControlConfig(in.section("control"), 0.1);
    readTimingConfig(in.section("timing"), 0.001);
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

TEST(ControlConfig, ReadsEveryKey) {
  const ControlConfig control = readControlConfig(reader().section("control"), 0.1);
  EXPECT_EQ(control.sampling_period, 0.1);
  EXPECT_EQ(control.roll_pitch.position_integral, 2.0);
  EXPECT_EQ(control.yaw.velocity, 7.0);
  EXPECT_EQ(control.altitude.position, 9.0);
  EXPECT_EQ(control.altitude.velocity_integral, 12.0);
  EXPECT_FALSE(control.position_loop);
  EXPECT_EQ(control.hold_time, 6.0);
  const TimingConfig timing = readTimingConfig(reader().section("timing"), 0.001);
  EXPECT_EQ(timing.steps, 100);
  EXPECT_EQ(timing.mode, TimingMode::kWallclock);
  EXPECT_EQ(timing.forgetting_factor, 0.94);
  EXPECT_EQ(timing.latency, 0.045);
  EXPECT_EQ(timing.jitter_std, 0.0056);
}

TEST(ControlConfig, ComplaintsSayFileLineKeyAndLimit) {
  const auto says = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
  };
  says(complaint("[5, 6, 7, 8]", "[5, 6, 7]"), "c.yaml:3: control.yaw");
  says(complaint("[5, 6, 7, 8]", "[5, -6, 7, 8]"), "c.yaml:3: control.yaw[1] = -6");
  says(complaint("hold_time: 6.0", "hold_time: -1"), "c.yaml:6: control.hold_time = -1");
  says(complaint("hold_time: 6.0", "hold_tim: 6.0"), "hold_time");
  says(complaint("  hold_time: 6.0", "  hold_time: 6.0\n  gain: 1"), "control.gain");
  says(complaint("position_loop: false", "position_loop: maybe"),
       "c.yaml:5: control.position_loop = maybe");
  says(complaint("sampling_period: 0.1", "sampling_period: 0.1005"),
       "whole number of simulation.step = 0.001 s (0.1 s or");
  says(complaint("latency: 0.045", "latency: 0.1"), "must be below sampling_period");
  says(complaint("mode: wallclock", "mode: realtime"), "lockstep");
  says(complaint("forgetting_factor: 0.94", "forgetting_factor: 1"),
       "timing.forgetting_factor = 1");
}

}  // namespace
}  // namespace quad_control
