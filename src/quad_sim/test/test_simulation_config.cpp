// The sections vehicle and simulation: every key, its limits and the text of the complaints.
#include <gmock/gmock.h>

#include "../src/wind_config.hpp"
#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using quad_support::ConfigReader;
using testing::HasSubstr;

const char* const kGood = R"(vehicle:
  urdf: hummingbird.urdf
  namespace: hummingbird
  mass: 0.73
simulation:
  step: 0.001
  gravity: 9.8
  multibody: folded
  profile: default
  ground: true
  initial_altitude: 5000.0
)";

SimulationConfig read(const std::string& text) {
  const ConfigReader file = ConfigReader::fromText(text, "c.yaml");
  return readSimulationConfig(file.section("vehicle"), file.section("simulation"));
}
std::string says(const std::string& from, const std::string& to) {
  return complaint<quad_support::ConfigError>([&] { read(replaced(kGood, from, to)); });
}

TEST(SimulationConfig, ReadsEveryKey) {
  const SimulationConfig c = read(kGood);
  EXPECT_EQ(c.vehicle_namespace, "hummingbird");
  EXPECT_EQ(c.mass, 0.73);
  EXPECT_EQ(c.options.step, 0.001);
  EXPECT_EQ(c.options.gravity, 9.8);
  EXPECT_TRUE(c.options.ground);
  EXPECT_EQ(c.initial_altitude, 5000);
  EXPECT_EQ(read(replaced(kGood, "0.73", "urdf")).mass, std::nullopt);
}

TEST(SimulationConfig, ModesProfilesAndQuirks) {
  EXPECT_EQ(read(kGood).options.multibody, Multibody::kFolded);
  EXPECT_EQ(read(replaced(kGood, "folded", "hinged")).options.multibody, Multibody::kHinged);
  const SimulationConfig compat =
      read(replaced(kGood, "profile: default", "profile: rotors_compat"));
  EXPECT_EQ(compat.options.profile, Profile::kRotorsCompat);
  EXPECT_TRUE(compat.options.allQuirks().stamp_ahead);
  const SimulationConfig one = read(
      replaced(kGood, "profile: default", "profile: default\n  quirks: [thrust_lag]\n  seed: 7"));
  EXPECT_TRUE(one.options.allQuirks().thrust_lag);
  EXPECT_FALSE(one.options.allQuirks().stamp_ahead);
  EXPECT_EQ(one.options.seed, 7U);
  EXPECT_THAT(says("profile: default", "profile: default\n  quirks: [wobble]"),
              HasSubstr("simulation.quirks"));
}

TEST(SimulationConfig, StartsInEquilibrium) {
  const SimulationConfig c = read(kGood);
  const VehicleModel& m = c.model;
  Simulator s = makeSimulator(c, m);
  EXPECT_EQ(m.mass, 0.73);
  EXPECT_EQ(s.state().p_WB, Eigen::Vector3d(0, 0, 5000));
  EXPECT_EQ(s.command(), std::vector<double>(4, hoverSpeed(m, 9.8)));
  EXPECT_EQ(s.state().rotor_speed, s.command());
}

TEST(SimulationConfig, ComplaintsNameLineKeyAndLimit) {
  EXPECT_THAT(says("hummingbird.urdf", "nobody.urdf"),
              HasSubstr("c.yaml:2: vehicle.urdf = nobody.urdf; is neither"));
  EXPECT_THAT(says("namespace: hummingbird", "namespace: /x"),
              HasSubstr("vehicle.namespace = /x; must be a ROS name"));
  EXPECT_THAT(says("0.73", "-1"), HasSubstr("vehicle.mass = -1"));
  EXPECT_THAT(says("step: 0.001", "step: 0.00100000005"), HasSubstr("whole number of nanoseconds"));
  EXPECT_THAT(says("0.73", "5"),
              testing::MatchesRegex(
                  "c.yaml:4: vehicle.mass = 5; hummingbird: hovering with 5 kg takes "
                  "1197.* rad/s, but the rotors turn at most 838 rad/s, which carries 2.45 kg"));
  EXPECT_THAT(says("0.73", "0.03"),
              testing::MatchesRegex("c.yaml:4: vehicle.mass = 0.03; .*must be > 0.036 kg.*"));
  EXPECT_THAT(says("gravity: 9.8", "gravity: -9.8"), HasSubstr("simulation.gravity = -9.8"));
  EXPECT_THAT(says("folded", "welded"), HasSubstr("simulation.multibody = welded"));
  EXPECT_THAT(says("initial_altitude: 5000.0", "initial_altitude: -1"),
              HasSubstr("initial_altitude = -1"));
  EXPECT_THAT(says("ground: true", "grund: true"), HasSubstr("simulation.ground is missing"));
  EXPECT_THAT(says("ground: true", "ground: true\n  sky: 1"), HasSubstr("simulation.sky"));
}

std::string withWind(const std::string& wind) {
  return replaced(kGood, "ground: true", "ground: true\n  wind: " + wind);
}

/// The state after a second in the air.
VehicleState after(const SimulationConfig& c) {
  Simulator s = makeSimulator(c, c.model);
  s.advance(1000);
  return s.state();
}

TEST(SimulationConfig, WindIsThatOfThePlugin) {
  const std::string tags =
      "<windDirection>0 1 "
      "0</windDirection><windForceMean>0.2</windForceMean><windSpeedMean>3</windSpeedMean>"
      "<windGustForceMean>0.5</windGustForceMean><windGustStart>0.25</"
      "windGustStart><windGustDuration>0.5</windGustDuration>"
      "<windSpeedAmplitude>1</windSpeedAmplitude><windFrequency>2</windFrequency><windPhase>0.1</"
      "windPhase>"
      "<turbulenceIntensity>1 2 0.5</turbulenceIntensity><turbulenceLength>50 40 "
      "30</turbulenceLength>";
  const SimulationConfig c = read(
      withWind("{direction: [0, 1, 0], force: 0.2, speed: 3, gust_force: 0.5, gust_start: 0.25, "
               "gust_duration: 0.5, "
               "speed_amplitude: 1, frequency: 2, phase: 0.1, turbulence_intensity: [1, 2, 0.5], "
               "turbulence_length: [50, 40, 30]}"));
  SimulationConfig declared = read(kGood);
  declared.model = parseVehicle(
      replaced(hummingbirdText(), "</robot>",
               "<gazebo><plugin name=\"w\" filename=\"librotors_gazebo_wind_plugin.so\">" + tags +
                   "</plugin></gazebo></robot>"),
      "m.urdf", 0.73);
  EXPECT_EQ(after(c).p_WB, after(declared).p_WB);
  EXPECT_EQ(after(c).q_WB.coeffs(), after(declared).q_WB.coeffs());
  EXPECT_NE(after(c).p_WB, after(read(kGood)).p_WB);

  putWind(*c.wind, declared.model);  // a second time: replaced, not added
  EXPECT_EQ(after(c).p_WB, after(declared).p_WB);
  putWind({}, declared.model);
  EXPECT_EQ(after(declared).p_WB, after(read(kGood)).p_WB);
}

TEST(SimulationConfig, ComplaintsAboutWind) {
  const auto about = [](const std::string& wind) {
    return complaint<quad_support::ConfigError>([&] { read(withWind(wind)); });
  };
  EXPECT_THAT(about("{force: 1e7}"),
              HasSubstr("c.yaml:11: simulation.wind.force = 1e7; must lie in [-1e+06, 1e+06] N"));
  EXPECT_THAT(about("{forces: 1}"), HasSubstr("simulation.wind.forces"));
  EXPECT_THAT(about("{direction: [0, 0, 0]}"), HasSubstr("simulation.wind.direction"));
  EXPECT_THAT(about("{direction: [1, 0]}"), HasSubstr("simulation.wind.direction"));
  EXPECT_THAT(about("{turbulence_intensity: [1, 1, 1], speed: 3}"),
              HasSubstr("needs turbulence_length"));
  EXPECT_THAT(about("{turbulence_intensity: [1, 1, 1], turbulence_length: [9, 9, 9]}"),
              HasSubstr("needs turbulence_speed"));
}

TEST(SimulationConfig, AUrdfBesideTheFileComesFirst) {
  EXPECT_EQ(findUrdf("CMakeLists.txt", "."), "./CMakeLists.txt");
  EXPECT_EQ(findUrdf("nobody.urdf", "."), "");
  EXPECT_EQ(findUrdf(hummingbirdPath(), "/"), hummingbirdPath());
}

}  // namespace
}  // namespace quad_sim
