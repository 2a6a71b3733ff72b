// The URDF reader: totals against figures worked out by hand from RotorS's description, and
// messages for broken models.
#include <gmock/gmock.h>

#include "hummingbird.hpp"
#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using quad_support::ConfigError;
using testing::HasSubstr;

std::string parseComplaint(const std::string& text) {
  return complaint<ConfigError>([&] { parseVehicle(text, "m.urdf"); });
}

TEST(VehicleModel, MassIsTheSumOfTheLinks) {
  // 0.68 base + 4 * 0.009 rotors + 0.015 IMU + 3 * 1e-5 markers; a handful of additions round to
  // 1e-16 each.
  EXPECT_NEAR(hummingbird().mass, 0.73103, 1e-15);
}

TEST(VehicleModel, TotalsAreThoseOfTheParallelAxisTheorem) {
  const VehicleModel m = hummingbird();
  const double com = 4 * 0.009 * 0.01 / 0.73103;
  EXPECT_NEAR(m.com_B.z(), com, 1e-15);
  EXPECT_NEAR(m.com_B.head<2>().norm(), 0.0, 1e-17);
  // A rotor's box, at its true mass: factor * (y² + z²) and so on.
  const double f = 0.0833333 * 0.009, x = 0.1, y = 0.015, z = 0.003;
  const double axial = f * (x * x + y * y);
  const double transverse = 0.5 * f * (x * x + y * y + 2 * z * z);
  const double sensors = 4 * 1e-5;
  const double steiner = 4 * 0.009 * 0.01 * 0.01 - 0.73103 * com * com;
  EXPECT_NEAR(m.inertia_B(0, 0),
              0.007 + 2 * 0.009 * 0.17 * 0.17 + steiner + sensors + 4 * transverse, 1e-15);
  EXPECT_NEAR(m.inertia_B(1, 1), m.inertia_B(0, 0), 1e-15);
  EXPECT_NEAR(m.inertia_B(2, 2), 0.012 + 4 * 0.009 * 0.17 * 0.17 + sensors + 4 * axial, 1e-15);
  EXPECT_NEAR(m.inertia_B(0, 1), 0.0, 1e-17);
  EXPECT_NEAR(m.rotors[0].axial_inertia, axial, 1e-18);
  EXPECT_NEAR(m.rotors[0].transverse_inertia, transverse, 1e-18);
}

TEST(VehicleModel, RotorsAreFrontLeftBackRight) {
  const VehicleModel m = hummingbird();
  ASSERT_EQ(m.rotors.size(), 4U);
  const double x[] = {0.17, 0, -0.17, 0}, y[] = {0, 0.17, 0, -0.17};
  const int spin[] = {-1, 1, -1, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(m.rotors[i].position_B, Eigen::Vector3d(x[i], y[i], 0.01)) << i;
    EXPECT_EQ(m.rotors[i].axis_B, Eigen::Vector3d::UnitZ()) << i;
    EXPECT_EQ(m.rotors[i].spin, spin[i]) << i;
    EXPECT_EQ(m.rotors[i].thrust_coefficient, 8.54858e-06);
    EXPECT_EQ(m.rotors[i].time_constant_up, 0.0125);
    EXPECT_EQ(m.rotors[i].time_constant_down, 0.025);
  }
}

TEST(VehicleModel, TotalMassIsTrimmedAtTheOriginOfBaseLink) {
  const VehicleModel as_is = hummingbird();
  const VehicleModel trimmed = loadVehicle(hummingbirdPath(), 0.73);
  EXPECT_EQ(trimmed.mass, 0.73);
  // First moment and inertia about base_link's origin stay; rounding only.
  EXPECT_NEAR(trimmed.mass * trimmed.com_B.z(), as_is.mass * as_is.com_B.z(), 1e-18);
  const auto aboutOrigin = [](const VehicleModel& m) {
    return m.inertia_B(0, 0) + m.mass * m.com_B.z() * m.com_B.z();
  };
  EXPECT_NEAR(aboutOrigin(trimmed), aboutOrigin(as_is), 1e-17);
  EXPECT_THAT(complaint<ConfigError>([] { loadVehicle(hummingbirdPath(), 0.03); }),
              HasSubstr("must be > 0.036"));
}

TEST(VehicleModel, HoverSpeedCarriesTheWeight) {
  const VehicleModel m = hummingbird();
  const double w = hoverSpeed(m, 9.8);
  EXPECT_NEAR(4 * 8.54858e-06 * w * w, 0.73103 * 9.8, 1e-14);
  EXPECT_NEAR(w, 457.72, 0.005);  // as printed
  EXPECT_THAT(complaint<std::invalid_argument>([&] { hoverSpeed(m, 98.0); }),
              HasSubstr("at most 838 rad/s"));
}

TEST(VehicleModel, SensorsAndBoxAreFound) {
  const VehicleModel m = hummingbird();
  ASSERT_EQ(m.sensors.size(), 4U);
  EXPECT_EQ(m.sensors[0].topic, "odometry_sensor1/odometry");
  EXPECT_EQ(m.sensors[0].frame, "hummingbird/odometry_sensor1");
  EXPECT_EQ(m.sensors[1].topic, "ground_truth/odometry");
  EXPECT_EQ(m.sensors[2].topic, "imu");
  EXPECT_EQ(m.sensors[2].frame, "hummingbird/imu_link");
  EXPECT_EQ(m.sensors[3].topic, "ground_truth/imu");
  ASSERT_EQ(m.boxes.size(), 1U);
  EXPECT_EQ(m.boxes[0].size, Eigen::Vector3d(0.1, 0.1, 0.12));
}

TEST(VehicleModel, TurnedLinksCarryTheirInertiaAlong) {
  // The base turned by 90 degrees about x inside base_link: its izz becomes the body's iyy.
  const std::string text = replaced(
      replaced(hummingbirdText(), "<parent link=\"hummingbird/base_link\"/>",
               "<origin rpy=\"1.5707963267948966 0 0\"/><parent link=\"hummingbird/base_link\"/>"),
      "iyy=\"0.007\"", "iyy=\"0.008\"");
  const VehicleModel straight =
      parseVehicle(replaced(hummingbirdText(), "iyy=\"0.007\"", "iyy=\"0.008\""), "m.urdf");
  const VehicleModel turned = parseVehicle(text, "m.urdf");
  EXPECT_NEAR(turned.inertia_B(1, 1) - straight.inertia_B(1, 1), 0.012 - 0.008, 1e-15);
  EXPECT_NEAR(turned.inertia_B(2, 2) - straight.inertia_B(2, 2), 0.008 - 0.012, 1e-15);
}

TEST(VehicleModel, MessagesNameFileLineAndTag) {
  const std::string good = hummingbirdText();
  EXPECT_THAT(
      parseComplaint(replaced(good, "<mass value=\"0.009\"", "<mass value=\"0\"")),
      testing::MatchesRegex("m.urdf:[0-9]+: link 'hummingbird/rotor_0': mass = 0 kg; must be > 0"));
  EXPECT_THAT(
      parseComplaint(replaced(good, "izz=\"0.012\"", "izz=\"-0.012\"")),
      HasSubstr("link 'hummingbird/base_link_inertia': the inertia is not positive definite"));
  EXPECT_THAT(
      parseComplaint(replaced(good, "<motorNumber>1<", "<motorNumber>0<")),
      testing::MatchesRegex(
          "m.urdf:[0-9]+: plugin 'rotor_1_motor_model' .*: motorNumber = 0 is taken by .*"));
  EXPECT_THAT(
      parseComplaint(replaced(good, "<motorNumber>3<", "<motorNumber>4<")),
      testing::MatchesRegex("m.urdf:[0-9]+: plugin 'rotor_3_motor_model' .*: motorNumber = 4 "
                            "leaves a gap: motor number "
                            "3 is missing: there are 0, 1, 2, 4; 4 rotors are numbered 0..3"));
  EXPECT_THAT(parseComplaint(replaced(good, "<motorNumber>3<", "<motorNumber>x<")),
              HasSubstr("motorNumber = x must be a number"));
  EXPECT_THAT(parseComplaint(replaced(good, "<motorConstant>8.54858e-06<", "<motorConstant>-1<")),
              HasSubstr("motorConstant = -1 must be > 0"));
  EXPECT_THAT(parseComplaint(replaced(good, ">cw<", ">left<")),
              HasSubstr("turningDirection = left must be cw or ccw"));
  EXPECT_THAT(
      parseComplaint(replaced(good, "<jointName>hummingbird/rotor_2_joint<", "<jointName>nobody<")),
      HasSubstr("jointName = nobody names no joint"));
  EXPECT_THAT(parseComplaint("<robot name='r'><link name='base_link'/></robot>"),
              HasSubstr("no rotor"));
  EXPECT_THAT(parseComplaint("<robot name='r'"), HasSubstr("m.urdf:"));
  EXPECT_THAT(parseComplaint(""), HasSubstr("m.urdf"));
}

TEST(VehicleModel, MassesThatAreNoNumbersAreNamed) {
  const std::string good = hummingbirdText();
  for (const char* text : {"nan", "inf"}) {
    EXPECT_THAT(
        parseComplaint(
            replaced(good, "<mass value=\"0.009\"", std::string("<mass value=\"") + text + "\"")),
        testing::MatchesRegex(std::string("m.urdf:[0-9]+: link 'hummingbird/rotor_0': mass = ") +
                              text + "; must be a finite number"));
  }
  EXPECT_THAT(parseComplaint(replaced(good, "<mass value=\"0.009\"", "<mass value=\"light\"")),
              testing::MatchesRegex(
                  "m.urdf:[0-9]+: link 'hummingbird/rotor_0': mass = light; must be a number"));
  EXPECT_THAT(parseComplaint(replaced(good, "izz=\"0.012\"", "izz=\"nan\"")),
              testing::MatchesRegex("m.urdf:[0-9]+: link 'hummingbird/base_link_inertia': izz = "
                                    "nan; must be a finite number"));
}

TEST(VehicleModel, AnInertiaThatNoBodyHasIsRefused) {
  const std::string good = hummingbirdText();
  EXPECT_THAT(
      parseComplaint(replaced(good, "izz=\"0.012\"", "izz=\"0.02\"")),
      testing::MatchesRegex("m.urdf:[0-9]+: link 'hummingbird/base_link_inertia': no body has the "
                            "principal moments of "
                            "inertia 0.007, 0.007 and 0.02 kg m.2: .*triangle inequality.*"));
  EXPECT_GT(
      parseVehicle(replaced(good, "izz=\"0.012\"", "izz=\"0.014\""), "m.urdf").inertia_B(2, 2),
      0.014);  // a plate
}

/// `text` without the <gazebo> element around `word`.
std::string withoutGazebo(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  EXPECT_NE(at, std::string::npos) << word;
  const auto begin = text.rfind("<gazebo", at),
             end = text.find("</gazebo>", at) + std::string("</gazebo>").size();
  return text.substr(0, begin) + text.substr(end);
}

TEST(VehicleModel, ARotorWithoutMotorPluginIsNamed) {
  const std::string good = hummingbirdText();
  EXPECT_THAT(
      parseComplaint(withoutGazebo(good, "rotor_3_motor_model")),
      testing::MatchesRegex("m.urdf:[0-9]+: joint 'hummingbird/rotor_3_joint': no motor plugin "
                            "drives it and its link "
                            "'hummingbird/rotor_3'; motor numbers 0..2 are other joints'.*"));
  EXPECT_THAT(parseComplaint(withoutGazebo(good, "rotor_1_motor_model")),
              testing::MatchesRegex("m.urdf:[0-9]+: joint 'hummingbird/rotor_1_joint': "
                                    ".*'hummingbird/rotor_1'; motor number 1 is "
                                    "missing: there are 0, 2, 3.*"));
}

TEST(VehicleModel, AnUnknownPluginListsTheKnownOnes) {
  const std::string text = parseComplaint(
      replaced(hummingbirdText(), "librotors_gazebo_imu_plugin.so", "libnosuchplugin.so"));
  EXPECT_THAT(text, HasSubstr("no plugin is called libnosuchplugin.so; built in are "));
  EXPECT_THAT(text, HasSubstr("as a library: libnosuchplugin.so"));  // the loader's own words
  for (const std::string& name : knownPlugins()) EXPECT_THAT(text, HasSubstr(name));
}

TEST(VehicleModel, WhatIsLeftOutIsListed) {
  EXPECT_THAT(ignoredPlugins(hummingbird()), testing::IsEmpty());
  const std::string gps = replaced(hummingbirdText(), "librotors_gazebo_imu_plugin.so",
                                   "librotors_gazebo_gps_plugin.so");
  EXPECT_THAT(ignoredPlugins(parseVehicle(gps, "m.urdf")),
              testing::ElementsAre("librotors_gazebo_gps_plugin.so (imu)"));
}

TEST(VehicleModel, PluginsOfSensorsAreFoundToo) {
  const std::string camera =
      "<gazebo reference=\"hummingbird/base_link\"><sensor type=\"camera\" "
      "name=\"c\"><update_rate>30</update_rate>"
      "<plugin name=\"eye\" filename=\"libgazebo_ros_camera.so\"/></sensor></gazebo></robot>";
  const VehicleModel m = parseVehicle(replaced(hummingbirdText(), "</robot>", camera), "m.urdf");
  EXPECT_THAT(ignoredPlugins(m), testing::Contains("libgazebo_ros_camera.so (eye)"));
  EXPECT_THAT(parseComplaint(replaced(hummingbirdText(), "</robot>",
                                      replaced(camera, "libgazebo_ros_camera.so", "libnobody.so"))),
              HasSubstr("no plugin is called libnobody.so; built in are"));
}

TEST(Quirks, EachHasANameAndTheProfileIsAllOfThem) {
  EXPECT_EQ(RotorsQuirks::names().size(), sizeof(RotorsQuirks));
  RotorsQuirks one_by_one;
  for (const std::string& name : RotorsQuirks::names()) {
    EXPECT_FALSE(one_by_one.byName(name)) << name;
    one_by_one.byName(name) = true;
    EXPECT_TRUE(RotorsQuirks::all().byName(name)) << name;
  }
  EXPECT_THAT(complaint<std::invalid_argument>([&] { one_by_one.byName("wobble"); }),
              HasSubstr("wobble; must be one of thrust_lag, "));
}

TEST(VehicleModel, ALibraryOfItsOwnActsOnTheVehicle) {
  const std::string element = std::string("<gazebo><plugin name=\"push\" filename=\"") +
                              QUAD_SIM_TEST_PLUGIN +
                              "\"><force>0.5</force></plugin></gazebo></robot>";
  const VehicleModel pushed =
      parseVehicle(replaced(hummingbirdText(), "</robot>", element), "m.urdf");
  SimulatorOptions options;
  options.ground = false;
  Simulator s(pushed, options);
  s.setStartState(equilibrium(pushed, options.gravity, 10));
  s.advance(1);
  EXPECT_NEAR(s.state().v_WB.y(), 0.5 / pushed.mass * 0.001, 1e-15);  // F h / m
  EXPECT_THAT(
      parseComplaint(replaced(hummingbirdText(), "librotors_gazebo_imu_plugin.so", "libm.so.6")),
      HasSubstr("it is no plugin"));
}

TEST(VehicleModel, BrokenModelsAreRefusedOrFly) {
  // Whatever line is missing: either a vehicle with sound totals or std::invalid_argument, never
  // anything else.
  const std::string good = hummingbirdText();
  int refused = 0, accepted = 0;
  for (std::size_t begin = 0; begin < good.size();) {
    const std::size_t end = std::min(good.find('\n', begin), good.size() - 1) + 1;
    SCOPED_TRACE(good.substr(begin, end - begin));
    try {
      const VehicleModel m = parseVehicle(good.substr(0, begin) + good.substr(end), "m.urdf");
      ++accepted;
      EXPECT_GT(m.mass, 0);
      EXPECT_GT(m.inertia_B.determinant(), 0);
      EXPECT_FALSE(m.rotors.empty());
    } catch (const std::invalid_argument&) {
      ++refused;
    }
    begin = end;
  }
  EXPECT_GT(refused, 50);   // every mass, inertia, joint and motor line is needed
  EXPECT_GT(accepted, 50);  // comments, visuals, tags with defaults
}

TEST(VehicleModel, CutTextIsRefused) {
  const std::string good = hummingbirdText();
  for (std::size_t length = 0; length + 10 < good.size(); length += 97) {
    EXPECT_THROW(parseVehicle(good.substr(0, length), "m.urdf"), std::invalid_argument) << length;
  }
}

TEST(VehicleModel, AMissingFileIsBadInput) {
  EXPECT_THROW(loadVehicle("no/such.urdf"), std::invalid_argument);
}

}  // namespace
}  // namespace quad_sim
