// RotorS's vehicles, described in its style, and ours: they load unchanged, weigh what they should,
// hover in both ways of modelling.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "hummingbird.hpp"
#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"
#include "rotors_style.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

VehicleModel styled(const test::StyleVehicle& v) {
  return parseVehicle(test::urdf(v), v.ns + ".urdf");
}
VehicleModel shipped(const std::string& name) { return loadVehicle(findUrdf(name + ".urdf", "")); }

/// Hovers for two seconds at its equilibrium, level or with the centre of mass under the thrust's
/// axis.
void expectHover(const VehicleModel& m) {
  for (const Multibody multibody : {Multibody::kFolded, Multibody::kHinged}) {
    SimulatorOptions options;
    options.multibody = multibody;
    options.ground = false;
    Simulator s(m, options);
    s.setStartState(equilibrium(m, 9.8, 10));
    s.advance(1);
    const Vector3d a = s.specificForce(SensorModel{});
    EXPECT_NEAR(a.z(), 9.8, 0.3)
        << m.name;  // at base_link's origin: an unbalanced vehicle begins to turn
    s.setStartState(s.state());
    s.advance(500);
    EXPECT_TRUE(s.state().p_WB.allFinite());
  }
}

TEST(RotorsStyle, FireflyLoadsAndHovers) {
  const VehicleModel m = styled(test::firefly());
  EXPECT_NEAR(m.mass, 1.5 + 6 * 0.005 + 0.015 + 0.00001, 1e-12);
  ASSERT_EQ(m.rotors.size(), 6U);
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(m.rotors[static_cast<std::size_t>(i)].spin, i % 2 == 0 ? 1 : -1) << i;
  EXPECT_NEAR((m.rotors[2].position_B - Vector3d(-0.866025403784 * 0.215, 0.1075, 0.037)).norm(), 0,
              1e-12);
  EXPECT_NEAR(hoverSpeed(m, 9.8), std::sqrt(m.mass * 9.8 / (6 * 8.54858e-06)), 1e-9);
  // RotorS's own figures: no body has them, and it must fly all the same.
  ASSERT_EQ(m.notes.size(), 1U);
  EXPECT_THAT(m.notes[0],
              HasSubstr("firefly/base_link_inertia': no body has the principal moments"));
  SimulatorOptions options;
  Simulator s(m, options);
  s.setStartState(equilibrium(m, 9.8, 10));
  s.advance(5000);
  EXPECT_NEAR(s.state().p_WB.z(), 10, 1e-9);
  expectHover(m);
}

TEST(RotorsStyle, PelicanLoadsAndHovers) {
  const VehicleModel m = styled(test::pelican());
  EXPECT_NEAR(m.mass, 1.0 + 4 * 0.01 + 0.015 + 0.00001, 1e-12);
  EXPECT_EQ(m.rotors[1].thrust_coefficient, 9.9865e-06);
  EXPECT_TRUE(m.notes.empty());
  expectHover(m);
}

TEST(RotorsStyle, IrisHasItsRotorsAcross) {
  const VehicleModel m = styled(test::iris());
  EXPECT_NEAR(m.mass, 1.5 + 4 * 0.005 + 0.015 + 0.00001, 1e-12);
  EXPECT_EQ(m.rotors[0].position_B, Vector3d(0.13, -0.22, 0.023));
  EXPECT_EQ(m.rotors[0].spin, 1);
  EXPECT_EQ(m.rotors[2].spin, -1);
  expectHover(m);
}

TEST(RotorsStyle, AsymmetricQuadrotorHasItsRotorsOnArms) {
  const VehicleModel m = styled(test::asymmetric());
  const double third = 2 * M_PI / 3;
  EXPECT_NEAR(
      (m.rotors[1].position_B - Vector3d(0.6 * std::cos(third), 0.6 * std::sin(third), 0.03))
          .norm(),
      0, 1e-12);
  EXPECT_NEAR((m.rotors[2].position_B - Vector3d(-0.2, 0, 0.03)).norm(), 0, 1e-12);
  EXPECT_NEAR(
      (m.rotors[3].position_B - Vector3d(0.6 * std::cos(third), -0.6 * std::sin(third), 0.03))
          .norm(),
      0, 1e-12);
  EXPECT_EQ(m.boxes.size(), 5U);  // body and arms
  EXPECT_NEAR(m.mass,
              1.0 + 4 * 0.01 + (0.01 / 3 + 0.05 / 9) * 2 + 0.01 + 0.01 / 3 + 0.01 + 0.015 + 0.00001,
              1e-12);
  EXPECT_EQ(m.rotors[0].max_speed, 1000);
  expectHover(m);
}

TEST(RotorsStyle, PluginsWithoutEffectAreListedOnce) {
  test::StyleVehicle firefly = test::firefly();
  for (const char* name : {"gps", "gps2"}) {
    firefly.extra += fmt::format(
        "<gazebo><plugin filename=\"librotors_gazebo_gps_plugin.so\" name=\"{}\"/></gazebo>", name);
  }
  const VehicleModel m = styled(firefly);
  EXPECT_THAT(ignoredPlugins(m),
              testing::ElementsAre("librotors_gazebo_gps_plugin.so (gps, gps2)"));
  EXPECT_EQ(pluginRole(m.plugins[0]), PluginRole::kOutside);
}

TEST(RotorsStyle, TiltedRotorsThrustAlongTheirAxes) {
  // A rotor's joint turned by 0.3 rad about x: its axis leans to -y, in both ways of modelling.
  const std::string text =
      replaced(test::urdf(test::pelican()), "<origin xyz=\"0 0.21 0.05\" rpy=\"0 0 0\"/>",
               "<origin xyz=\"0 0.21 0.05\" rpy=\"0.3 0 0\"/>");
  const VehicleModel m = parseVehicle(text, "tilted.urdf");
  EXPECT_NEAR((m.rotors[1].axis_B - Vector3d(0, -std::sin(0.3), std::cos(0.3))).norm(), 0, 1e-12);
  for (const Multibody multibody : {Multibody::kFolded, Multibody::kHinged}) {
    SimulatorOptions options;
    options.multibody = multibody;
    options.ground = false;
    Simulator s(m, options);
    VehicleState start;
    start.rotor_speed = {0, 500, 0, 0};
    s.setStartState(start);
    s.advance(1);
    const VehicleState end = s.state();
    const Vector3d v_C = end.v_WB + end.q_WB * end.w_WB_B.cross(m.com_B);
    const double thrust = 9.9865e-06 * 500 * 500;
    EXPECT_NEAR(v_C.y(), -std::sin(0.3) * thrust / m.mass * 0.001,
                2e-6);  // the turn within the step: w h²
    EXPECT_NEAR(v_C.z(), (std::cos(0.3) * thrust / m.mass - 9.8) * 0.001, 2e-6);
  }
}

TEST(Shipped, OursAreTheSameVehiclesAsInRotorsStyle) {
  for (const test::StyleVehicle& style : {test::firefly(), test::pelican()}) {
    const VehicleModel ours = shipped(style.ns), theirs = styled(style);
    SCOPED_TRACE(style.ns);
    // Ours carry the ground-truth sensors too: two links of 1e-5 kg and 1e-5 kg m². Moments of
    // rotors: 0.0833333 for a twelfth.
    EXPECT_NEAR(ours.mass, theirs.mass + 2e-5, 1e-12);
    EXPECT_LT((ours.inertia_B - theirs.inertia_B - 2e-5 * Eigen::Matrix3d::Identity()).norm(),
              1e-7);
    ASSERT_EQ(ours.rotors.size(), theirs.rotors.size());
    for (std::size_t i = 0; i < ours.rotors.size(); ++i) {
      EXPECT_LT((ours.rotors[i].position_B - theirs.rotors[i].position_B).norm(), 1e-12);
      EXPECT_EQ(ours.rotors[i].spin, theirs.rotors[i].spin);
      EXPECT_EQ(ours.rotors[i].thrust_coefficient, theirs.rotors[i].thrust_coefficient);
    }
    EXPECT_EQ(ours.boxes[0].size, theirs.boxes[0].size);
    expectHover(ours);
  }
}

TEST(RotorsStyle, MacrosWithBlocksAndIncludesExpand) {
  // RotorS's way of writing: properties, property blocks, macros with block parameters, includes of
  // a second file, an argument.
  const std::string folder = testing::TempDir() + "rotors_style";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/parts.xacro") << R"xacro(<?xml version="1.0"?>
<robot xmlns:xacro="http://ros.org/wiki/xacro">
  <xacro:macro name="solid_inertia" params="x y z mass">
    <inertia ixx="${0.0833333 * mass * (y*y + z*z)}" ixy="0.0" ixz="0.0" iyy="${0.0833333 * mass * (x*x + z*z)}" iyz="0.0"
      izz="${0.0833333 * mass * (x*x + y*y)}" />
  </xacro:macro>
  <xacro:macro name="upright_rotor" params="robot_namespace suffix direction parent mass_rotor motor_number *origin *inertia">
    <joint name="${robot_namespace}/rotor_${motor_number}_joint" type="continuous">
      <xacro:insert_block name="origin" />
      <axis xyz="0 0 1" />
      <parent link="${parent}" />
      <child link="${robot_namespace}/rotor_${motor_number}" />
    </joint>
    <link name="${robot_namespace}/rotor_${motor_number}">
      <inertial><mass value="${mass_rotor}" /><xacro:insert_block name="inertia" /></inertial>
    </link>
    <gazebo>
      <plugin name="${robot_namespace}_${suffix}_motor_model" filename="librotors_gazebo_motor_model.so">
        <jointName>${robot_namespace}/rotor_${motor_number}_joint</jointName>
        <linkName>${robot_namespace}/rotor_${motor_number}</linkName>
        <turningDirection>${direction}</turningDirection>
        <motorNumber>${motor_number}</motorNumber>
      </plugin>
    </gazebo>
  </xacro:macro>
</robot>)xacro";
  std::ofstream(folder + "/tri.xacro") << R"xacro(<?xml version="1.0"?>
<robot name="$(arg mav_name)" xmlns:xacro="http://ros.org/wiki/xacro">
  <xacro:property name="namespace" value="$(arg mav_name)" />
  <xacro:property name="rotor_velocity_slowdown_sim" value="10" />
  <xacro:property name="mass_rotor" value="0.01" /> <!-- [kg] -->
  <xacro:property name="arm_length" value="0.2" /> <!-- [m] -->
  <xacro:property name="rotor_inertia">
    <xacro:solid_inertia x="0.1" y="0.015" z="0.003" mass="${mass_rotor*rotor_velocity_slowdown_sim}" />
  </xacro:property>
  <xacro:include filename="parts.xacro" />
  <link name="${namespace}/base_link"></link>
  <joint name="${namespace}/base_joint" type="fixed">
    <origin xyz="0 0 0" rpy="0 0 0" /><parent link="${namespace}/base_link" /><child link="${namespace}/base_link_inertia" />
  </joint>
  <link name="${namespace}/base_link_inertia">
    <inertial><mass value="0.6" /><origin xyz="0 0 0" /><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.02" /></inertial>
  </link>
  <xacro:upright_rotor robot_namespace="${namespace}" suffix="a" direction="ccw" parent="${namespace}/base_link"
    mass_rotor="${mass_rotor}" motor_number="0">
    <origin xyz="${arm_length} 0 0.01" rpy="0 0 0" />
    <xacro:insert_block name="rotor_inertia" />
  </xacro:upright_rotor>
  <xacro:upright_rotor robot_namespace="${namespace}" suffix="b" direction="cw" parent="${namespace}/base_link"
    mass_rotor="${mass_rotor}" motor_number="1">
    <origin xyz="-${arm_length/2} ${arm_length*0.8} 0.01" rpy="0 0 0" />
    <xacro:insert_block name="rotor_inertia" />
  </xacro:upright_rotor>
  <xacro:upright_rotor robot_namespace="${namespace}" suffix="c" direction="ccw" parent="${namespace}/base_link"
    mass_rotor="${mass_rotor}" motor_number="2">
    <origin xyz="-${arm_length/2} -${arm_length*0.8} 0.01" rpy="0 0 0" />
    <xacro:insert_block name="rotor_inertia" />
  </xacro:upright_rotor>
</robot>)xacro";
  const std::string out = folder + "/tri.urdf";
  ASSERT_EQ(std::system(
                (std::string(XACRO) + " " + folder + "/tri.xacro mav_name:=tri -o " + out).c_str()),
            0);
  const VehicleModel m = loadVehicle(out);
  EXPECT_EQ(m.name, "tri");
  EXPECT_NEAR(m.mass, 0.63, 1e-12);
  EXPECT_LT((m.rotors[2].position_B - Vector3d(-0.1, -0.16, 0.01)).norm(),
            1e-15);  // 0.2 * 0.8 as Python rounds it
  EXPECT_NEAR(m.rotors[0].axial_inertia, 0.0833333 * 0.01 * (0.01 + 0.015 * 0.015), 1e-15);
  EXPECT_EQ(m.rotors[0].drag_coefficient, 1.0e-4);  // RotorS's value where the tag is absent
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace quad_sim
