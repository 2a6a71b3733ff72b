// quad_sim simulate: the contract of its files, and the program's exit codes.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "hummingbird.hpp"
#include "quad_sim/replay.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using quad_support::CsvTable;
using testing::HasSubstr;
namespace fs = std::filesystem;

Simulator atRest(double step = 0.001) {
  SimulatorOptions options;
  options.step = step;
  options.ground = false;
  return Simulator(hummingbird(), options);
}

CsvTable run(Simulator& s, const std::string& commands, std::int64_t steps, std::int64_t every) {
  return CsvTable::parse(
      replay(s, readCommands(CsvTable::parse(commands, "c.csv"), 4), steps, every), "out");
}

TEST(Replay, RowsRunFromZeroToTheEndInclusive) {
  Simulator s = atRest();
  const CsvTable out = run(s, "t,w0,w1,w2,w3\n0,460,460,460,460\n", 10, 4);
  ASSERT_EQ(out.rows(), 4U);  // 0, 4, 8 and the last
  EXPECT_EQ(out.text(1, "t"), "0.004");
  EXPECT_EQ(out.text(3, "t"), "0.01");
  EXPECT_EQ(out.number(0, "z"), 0.06);
  EXPECT_EQ(out.columns().size(), 18U);
}

TEST(Replay, ACommandActsFromTheFirstStepAtOrAfterItsTime) {
  Simulator s = atRest();
  const CsvTable out = run(s, "t,w0,w1,w2,w3\n0.0015,100,0,0,0\n0.003,0,100,0,0\n", 5, 1);
  const double up = 100 * (1 - std::exp(-0.001 / 0.0125));
  EXPECT_EQ(out.number(2, "w0"), 0);            // at 2 ms: nothing has acted yet
  EXPECT_NEAR(out.number(3, "w0"), up, 1e-13);  // the step from 2 to 3 ms
  EXPECT_EQ(out.number(3, "w1"), 0);
  EXPECT_NEAR(out.number(4, "w1"), up, 1e-13);
  EXPECT_LT(out.number(4, "w0"), up);
}

TEST(Replay, StatesReadBackAsTheSameBits) {
  Simulator s = atRest();
  std::string csv = replay(
      s, readCommands(CsvTable::parse("t,w0,w1,w2,w3\n0,460,470,465,480\n", "c"), 4), 300, 300);
  // The last row without t is a state file.
  const std::string header = csv.substr(2, csv.find('\n') - 1);
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  const VehicleState back =
      readState(CsvTable::parse(header + last.substr(last.find(',') + 1), "s"), 4);
  const VehicleState now = s.state();
  EXPECT_EQ(back.p_WB, now.p_WB);
  EXPECT_EQ(back.q_WB.coeffs(), now.q_WB.coeffs());
  EXPECT_EQ(back.v_WB, now.v_WB);
  EXPECT_EQ(back.w_WB_B, now.w_WB_B);
  EXPECT_EQ(back.rotor_speed, now.rotor_speed);
}

TEST(Replay, BadTablesAreNamed) {
  const auto says = [](const std::string& text) {
    return complaint<quad_support::DataError>(
        [&] { readCommands(CsvTable::parse(text, "c.csv"), 4); });
  };
  EXPECT_THAT(says("t,w0,w1,w2\n"),
              HasSubstr("c.csv: columns are t,w0,w1,w2; must be t,w0,w1,w2,w3"));
  EXPECT_THAT(says("t,w0,w1,w2,w3\n0,1,1,1,1\n0,1,1,1,1\n"),
              HasSubstr("c.csv:3: t = 0 s; must be later"));
  EXPECT_THAT(says("t,w0,w1,w2,w3\n-1,1,1,1,1\n"), HasSubstr("c.csv:2: t = -1 s"));
  EXPECT_THAT(says("t,w0,w1,w2,w3\n0,1,x,1,1\n"), HasSubstr("w1"));
}

/// The installed contract: arguments in, exit code and file out.
class Program : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("quad_sim_test_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    quad_support::writeFileAtomically(path("c.csv"), "t,w0,w1,w2,w3\n0,460,460,460,460\n");
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  int call(const std::string& arguments) const {
    const std::string line = std::string(QUAD_SIM_PROGRAM) + " " + arguments + " >" +
                             path("stdout") + " 2>" + path("stderr");
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string errors() const { return quad_support::readFile(path("stderr")); }
  std::string usual() const {
    return "simulate --urdf " + hummingbirdPath() + " --commands " + path("c.csv") + " --out " +
           path("o.csv");
  }
  fs::path folder_;
};

TEST_F(Program, WritesWhatTheLibraryDoes) {
  ASSERT_EQ(call(usual() + " --duration 0.5 --every 100"), 0) << errors();
  Simulator s = atRest();
  const auto commands = readCommands(CsvTable::parse("t,w0,w1,w2,w3\n0,460,460,460,460\n", "c"), 4);
  EXPECT_EQ(quad_support::readFile(path("o.csv")), replay(s, commands, 500, 100));
}

TEST_F(Program, ASeedPicksTheTurbulence) {
  const std::string wind =
      R"(<gazebo><plugin name="wind" filename="librotors_gazebo_wind_plugin.so"><windSpeedMean>5</windSpeedMean>
         <turbulenceIntensity>1 1 1</turbulenceIntensity><turbulenceLength>50 50 50</turbulenceLength></plugin></gazebo></robot>)";
  std::ofstream(path("gusty.urdf")) << replaced(hummingbirdText(), "</robot>", wind);
  const auto states = [&](const std::string& seed) {
    EXPECT_EQ(call("simulate --urdf " + path("gusty.urdf") + " --commands " + path("c.csv") +
                   " --out " + path("o.csv") + " --duration 0.5 --every 100" + seed),
              0)
        << errors();
    return quad_support::readFile(path("o.csv"));
  };
  EXPECT_EQ(states(" --seed 7"), states(" --seed 7"));
  EXPECT_EQ(states(" --seed 0"), states(""));
  EXPECT_NE(states(" --seed 8"), states(" --seed 7"));
}

TEST_F(Program, PluginsWithoutEffectAreListedOnRequest) {
  std::ofstream(path("gps.urdf")) << replaced(hummingbirdText(), "librotors_gazebo_imu_plugin.so",
                                              "librotors_gazebo_gps_plugin.so");
  const std::string with_gps = "simulate --urdf " + path("gps.urdf") + " --commands " +
                               path("c.csv") + " --out " + path("o.csv");
  ASSERT_EQ(call(with_gps + " --duration 0.1"), 0) << errors();
  EXPECT_EQ(errors(), "");
  ASSERT_EQ(call(with_gps + " --duration 0.1 --verbose"), 0) << errors();
  EXPECT_THAT(errors(), HasSubstr("without effect here: librotors_gazebo_gps_plugin.so (imu)"));
}

TEST_F(Program, BadInputIsExitTwoAndLeavesNoFile) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {usual(), "--duration is required"},
      {usual() + " --duration 0.0005", "whole number of steps"},
      {usual() + " --duration -1", "--duration -1"},
      {usual() + " --duration 1 --every 0", "--every 0"},
      {usual() + " --duration 1 --ground perhaps", "must be off or on"},
      {usual() + " --duration 1 --step 0", "quad_sim: --step 0 s; must be a whole number"},
      {usual() + " --duration 1 --gravity -1", "quad_sim: --gravity -1 m/s^2; must be >= 0"},
      {usual() + " --duration 1 --mode loose", "quad_sim: --mode loose; must be folded or hinged"},
      {usual() + " --duration 1 --profile gazebo",
       "quad_sim: --profile gazebo; must be default or rotors_compat"},
      {usual() + " --duration 1 --quirks thrust_lag,wobble",
       "quad_sim: --quirks wobble; must be one of thrust_lag, "},
      {usual() + " --duration 1 --state " + path("nothing.csv"), "nothing.csv"},
      {"fly", "--help"},
  };
  for (const auto& [arguments, text] : cases) {
    SCOPED_TRACE(arguments);
    EXPECT_EQ(call(arguments), 2);
    EXPECT_THAT(errors(), HasSubstr(text));
    EXPECT_FALSE(fs::exists(path("o.csv")));
  }
}

TEST_F(Program, AStartOutOfRangeIsNamedWithItsFile) {
  const std::string header = "x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,w0,w1,w2,w3\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {header + "0,0,1,1,0,0,0,0,0,0,0,0,0,0,0,-1,0\n", "x0.csv:2: vehicle state: rotor_speed[2]"},
      {header, "x0.csv: 0 rows; must be one"},
      {"x,y\n0,0\n", "x0.csv: columns are x,y; must be"},
  };
  for (const auto& [text, complaint] : cases) {
    quad_support::writeFileAtomically(path("x0.csv"), text);
    EXPECT_EQ(call(usual() + " --duration 1 --state " + path("x0.csv")), 2);
    EXPECT_THAT(errors(), HasSubstr(complaint));
    EXPECT_FALSE(fs::exists(path("o.csv")));
  }
}

TEST_F(Program, AnUnwritablePlaceIsExitFive) {
  EXPECT_EQ(call("simulate --urdf " + hummingbirdPath() + " --commands " + path("c.csv") +
                 " --duration 0.1 --out " + path("no/such/o.csv")),
            5);
}

TEST_F(Program, SaysItsVersion) {
  EXPECT_EQ(call("--version"), 0);
  EXPECT_EQ(quad_support::readFile(path("stdout")), std::string(quad_support::kVersion) + "\n");
}

TEST_F(Program, HelpShowsAnExample) {
  EXPECT_EQ(call("simulate --help"), 0);
  EXPECT_THAT(quad_support::readFile(path("stdout")),
              HasSubstr("--urdf build/urdf/hummingbird.urdf"));
}

}  // namespace
}  // namespace quad_sim
