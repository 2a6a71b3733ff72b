#include <gtest/gtest.h>

#include "quad_experiment/experiment_config.hpp"
#include "quad_support/errors.hpp"
#include "scratch.hpp"

using namespace quad_experiment;

namespace {

std::string complaint(const std::vector<std::pair<std::string, std::string>>& changes) {
  const Scratch scratch;
  const std::string path = scratch.path("c.yaml");
  quad_support::writeFileAtomically(path, shippedConfig("thesis.yaml", changes));
  try {
    readExperimentConfig(path);
  } catch (const quad_support::ConfigError& e) {
    return std::string(e.what()).substr(path.size() - 6);  // from "c.yaml:" on
  }
  return "no error";
}

void expectComplaint(const std::vector<std::pair<std::string, std::string>>& changes,
                     const std::vector<std::string>& parts) {
  const std::string message = complaint(changes);
  for (const auto& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

}  // namespace

TEST(ExperimentConfig, ShippedFilesAreValid) {
  for (const char* name : {"thesis.yaml", "exact.yaml", "wallclock.yaml", "smoke.yaml"}) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(readExperimentConfig(std::string("config/") + name));
  }
}

TEST(ExperimentConfig,
     ShippedFilesFlyTheSameGains) {  // derived once, see docs/design/0002-control-gains.md
  const quad_control::ControlConfig thesis = readExperimentConfig("config/thesis.yaml").control;
  for (const char* name : {"exact.yaml", "wallclock.yaml", "smoke.yaml"}) {
    SCOPED_TRACE(name);
    const quad_control::ControlConfig other =
        readExperimentConfig(std::string("config/") + name).control;
    for (const auto gains :
         {&quad_control::ControlConfig::roll_pitch, &quad_control::ControlConfig::yaw,
          &quad_control::ControlConfig::altitude}) {
      EXPECT_EQ((thesis.*gains).position, (other.*gains).position);
      EXPECT_EQ((thesis.*gains).position_integral, (other.*gains).position_integral);
      EXPECT_EQ((thesis.*gains).velocity, (other.*gains).velocity);
      EXPECT_EQ((thesis.*gains).velocity_integral, (other.*gains).velocity_integral);
    }
  }
}

TEST(ExperimentConfig, ALatencyBetweenStepsIsNoted) {
  EXPECT_EQ(notes(readExperimentConfig("config/thesis.yaml")), std::vector<std::string>());
  const Scratch scratch;
  quad_support::writeFileAtomically(
      scratch.path("c.yaml"),
      shippedConfig("thesis.yaml", {{"latency: 0.045", "latency: 0.0453"}}));
  const ExperimentConfig config = readExperimentConfig(scratch.path("c.yaml"));
  EXPECT_EQ(notes(config), std::vector<std::string>(
                               {"timing.latency = 0.0453 s is flown as 0.045 s, a whole number of "
                                "simulation.step = 0.001 s: 0.3 ms less"}));
  EXPECT_EQ(Middleware(middlewareConfig(config), 1, 0).interval(0).hold_steps, 45);
}

TEST(ExperimentConfig, AHoldBetweenIntervalsIsNoted) {
  const Scratch scratch;
  const auto noted = [&](const char* hold, const char* mode) {
    quad_support::writeFileAtomically(
        scratch.path("c.yaml"),
        shippedConfig("thesis.yaml", {{"hold_time: 6.0", hold}, {"mode: lockstep", mode}}));
    return notes(readExperimentConfig(scratch.path("c.yaml")));
  };
  EXPECT_EQ(
      noted("hold_time: 0.26", "mode: lockstep"),
      std::vector<std::string>({"control.hold_time = 0.26 s is flown as 0.3 s, a whole number "
                                "of timing.sampling_period = 0.1 s: 40 ms more"}));
  EXPECT_TRUE(noted("hold_time: 0.3", "mode: lockstep").empty());  // 0.3 / 0.1 < 3 in doubles
  EXPECT_TRUE(noted("hold_time: 0.26", "mode: wallclock").empty());
}

TEST(ExperimentConfig, ResolvedYamlReadsBackToTheSameConfiguration) {
  const Scratch scratch;
  quad_support::writeFileAtomically(
      scratch.path("windy.yaml"),
      shippedConfig(
          "thesis.yaml",
          {{"ground: true", "ground: true\n  wind: {speed: 0.1, direction: [0.6, 0, -0.8]}"}}));
  const ExperimentConfig config = readExperimentConfig(scratch.path("windy.yaml"));
  EXPECT_NE(configHash(config), configHash(readExperimentConfig("config/thesis.yaml")));
  quad_support::writeFileAtomically(scratch.path("c.yaml"), toYaml(config));
  const ExperimentConfig again = readExperimentConfig(scratch.path("c.yaml"));
  EXPECT_EQ(toYaml(again), toYaml(config));
  EXPECT_EQ(configHash(again), configHash(config));
}

TEST(ExperimentConfig, MistakesNameKeyValueAndLimit) {
  expectComplaint({{"gamma_w: 20.0", "gamma_w: -1"}},
                  {"c.yaml:", "design.gamma_w = -1", "must be > 0"});
  expectComplaint({{"gamma_w: 20.0", "gamma_w: .nan"}},
                  {"design.gamma_w = .nan", "must be a finite number > 0"});
  expectComplaint({{"[3, 6, 8, 10]", "[3, 6, 6, 10]"}},
                  {"design.harmonics[2] = 6", "stands twice", "T/2 = 185"});
  expectComplaint({{"[3, 6, 8, 10]", "[3, 6, 8.5, 10]"}},
                  {"design.harmonics[2] = 8.5", "whole number in 1..184"});
  expectComplaint({{"[3, 6, 8, 10]", "[3, 6, 8, 185]"}},
                  {"design.harmonics[3] = 185", "whole number in 1..184"});
  expectComplaint({{"sampling_period: 0.1 ", "sampling_period: 0.1005 "}},
                  {"timing.sampling_period = 0.1005", "0.001"});
  expectComplaint({{"mass: 0.73 ", "mass: -0.73 "}}, {"vehicle.mass = -0.73"});
  expectComplaint({{"seed: 1 ", "sede: 1 "}}, {"seed is missing"});
  expectComplaint({{"seed: 1 ", "seed: 1\nextra: 1 "}}, {"extra is not a key"});
  expectComplaint({{"method: global", "method: best"}},
                  {"design.method = best", "must be one of: global, mm"});
  expectComplaint({{"[0.04, 0.94, 1.76, -2.62]", "[0.04, 0.94]"}},
                  {"design.amplitudes", "list of 4 numbers"});
  expectComplaint({{"latency: 0.045", "latency: 0.1"}}, {"timing.latency = 0.1"});
  expectComplaint({{"gamma_w: 20.0", "gamma_w: 20.0\n  gamma_w: 21.0"}},
                  {"design.gamma_w stands twice"});
  expectComplaint({{"sampling_period: 0.1 ", "sampling_period: 1e7 "}},
                  {"timing.sampling_period = 1e7", "60"});
  expectComplaint({{"jitter_std: 0.0056", "jitter_std: 1e7"}}, {"timing.jitter_std = 1e7", "0.1"});
  expectComplaint({{"hold_time: 6.0", "hold_time: 1e9"}}, {"control.hold_time = 1e9", "3600"});
  expectComplaint({{"hold_time: 6.0", "hold_time: 0.04"}},
                  {"control.hold_time = 0.04; must be at least one interval of 0.1 s"});
  expectComplaint({{"mass: 0.6247", "mass: 3"}}, {"estimate.mass = 3", "must be below"});
  expectComplaint({{"gravity: 9.8", "gravity: 0"}}, {"simulation.gravity = 0", "must be > 0"});
  expectComplaint({{"altitude: [2.4, 0.7, 2.4, 0.6]", "altitude: [2.4, 0, 2.4, 0]"}},
                  {"control.altitude", "integral gain"});
  expectComplaint({{"[0.04, 0.94, 1.76, -2.62]", "[1e300, 0.94, 1.76, -2.62]"}},
                  {"design.amplitudes[0] = 1e300"});
  expectComplaint({{"urdf: hummingbird.urdf", "urdf: none.urdf"}}, {"vehicle.urdf = none.urdf"});
}

TEST(ExperimentConfig, TheModeAskedForReplacesTheFiles) {
  const ExperimentConfig file = readExperimentConfig("config/thesis.yaml", "lockstep");
  EXPECT_EQ(toYaml(file), toYaml(readExperimentConfig("config/thesis.yaml")));
  const ExperimentConfig real = readExperimentConfig("config/thesis.yaml", "wallclock");
  EXPECT_EQ(real.timing.mode, quad_control::TimingMode::kWallclock);
  EXPECT_EQ(real.timing.latency, 0.0);  // the middleware is not simulated there
  EXPECT_EQ(real.timing.jitter_std, 0.0);
  EXPECT_NE(configHash(real), configHash(file));
  EXPECT_THROW(readExperimentConfig("config/thesis.yaml", "warp"), quad_support::ConfigError);
}

TEST(ExperimentConfig, VehicleThatCannotFlyIsNamed) {
  std::string urdf =
      quad_support::readFile(readExperimentConfig("config/thesis.yaml").simulation.urdf);
  for (std::size_t at = 0; (at = urdf.find("<momentConstant>", at)) != std::string::npos; ++at) {
    urdf.replace(at, urdf.find('<', at + 1) - at, "<momentConstant>0");
  }
  const Scratch scratch;
  quad_support::writeFileAtomically(scratch.path("bee.urdf"), urdf);
  quad_support::writeFileAtomically(
      scratch.path("c.yaml"),
      shippedConfig("thesis.yaml", {{"urdf: hummingbird.urdf", "urdf: bee.urdf"}}));
  try {
    readExperimentConfig(scratch.path("c.yaml"));
    FAIL() << "without drag torque nothing turns the vehicle's heading";
  } catch (const quad_support::ConfigError& e) {
    EXPECT_EQ(std::string(e.what()).rfind(scratch.path("bee.urdf") + ": control allocation: ", 0),
              0u)
        << e.what();
  }
}

TEST(ExperimentConfig, EstimateCanBeDrawn) {
  const Scratch scratch;
  const std::string path = scratch.path("c.yaml");
  const std::string draw = "draw: {closeness: 50, seed: 1}\n";
  std::string text = shippedConfig("thesis.yaml");
  const auto from = text.find("  sampling_period: 0.1635");
  const auto to = text.find("design:");
  ASSERT_NE(from, std::string::npos);
  text.replace(from, to - from, "  " + draw);
  quad_support::writeFileAtomically(path, text);
  const ExperimentConfig config = readExperimentConfig(path);
  const explore_opt::AltitudeParameters truth = {0.1, 0.73};
  // The draw is scaled to the closeness asked for: by definition, up to the bisection's rounding.
  EXPECT_NEAR(explore_opt::closenessOfEstimate(truth, config.estimate.parameters), 50.0, 1e-9);
}
