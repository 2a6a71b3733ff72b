/// Vehicles described the way RotorS describes its own: the same macros' output, tags and their
/// order, names and units. Written anew for these tests; the figures are those of the vehicles'
/// descriptions.
#pragma once

#include <fmt/core.h>

#include <string>
#include <vector>

namespace quad_sim::test {

struct StyleRotor {
  double x, y, z;
  const char* direction;
  const char* parent = "base_link";  ///< without namespace
};

struct StyleVehicle {
  std::string ns;
  double mass, ixx, iyy, izz, width, height, rotor_mass, radius, thrust, max_speed;
  double rotor_ixx, rotor_iyy, rotor_izz;
  std::vector<StyleRotor> rotors;
  std::string extra;  ///< further elements
};

inline std::string box(double m, double x, double y, double z) {
  return fmt::format(
      "<inertia ixx=\"{}\" ixy=\"0.0\" ixz=\"0.0\" iyy=\"{}\" iyz=\"0.0\" izz=\"{}\"/>",
      m / 12 * (y * y + z * z), m / 12 * (x * x + z * z), m / 12 * (x * x + y * y));
}

inline std::string sensorLink(const std::string& ns, const std::string& name, double mass) {
  return fmt::format(
      "<link name=\"{0}/{1}_link\"><inertial><inertia ixx=\"0.00001\" ixy=\"0.0\" ixz=\"0.0\" "
      "iyy=\"0.00001\" iyz=\"0.0\" "
      "izz=\"0.00001\"/><mass value=\"{2}\"/><origin xyz=\"0 0 0\" rpy=\"0 0 "
      "0\"/></inertial></link>"
      "<joint name=\"{0}/{1}_joint\" type=\"revolute\"><origin xyz=\"0 0 0\" rpy=\"0 0 "
      "0\"/><parent link=\"{0}/base_link\"/>"
      "<child link=\"{0}/{1}_link\"/><limit upper=\"0\" lower=\"0\" effort=\"0\" "
      "velocity=\"0\"/></joint>\n",
      ns, name, mass);
}

inline std::string rotorElement(const StyleVehicle& v, std::size_t number) {
  const StyleRotor& r = v.rotors[number];
  return fmt::format(
      "<joint name=\"{ns}/rotor_{n}_joint\" type=\"continuous\"><origin xyz=\"{x} {y} {z}\" "
      "rpy=\"0 0 0\"/><axis xyz=\"0 0 1\"/>"
      "<parent link=\"{ns}/{parent}\"/><child link=\"{ns}/rotor_{n}\"/></joint>\n"
      "<link name=\"{ns}/rotor_{n}\"><inertial><mass value=\"{m}\"/><inertia ixx=\"{ixx}\" "
      "ixy=\"0.0\" ixz=\"0.0\" iyy=\"{iyy}\" "
      "iyz=\"0.0\" izz=\"{izz}\"/></inertial>"
      "<visual><geometry><mesh "
      "filename=\"package://rotors_description/meshes/propeller_{dir}.dae\" scale=\"0.1 0.1 "
      "0.1\"/></geometry>"
      "</visual><collision><geometry><cylinder length=\"0.005\" "
      "radius=\"{radius}\"/></geometry></collision></link>\n"
      "<gazebo><plugin name=\"{ns}_rotor_{n}_motor_model\" "
      "filename=\"librotors_gazebo_motor_model.so\">"
      "<robotNamespace>{ns}</robotNamespace><jointName>{ns}/rotor_{n}_joint</"
      "jointName><linkName>{ns}/rotor_{n}</linkName>"
      "<turningDirection>{dir}</turningDirection><timeConstantUp>0.0125</"
      "timeConstantUp><timeConstantDown>0.025</timeConstantDown>"
      "<maxRotVelocity>{max}</maxRotVelocity><motorConstant>{kf}</"
      "motorConstant><momentConstant>0.016</momentConstant>"
      "<commandSubTopic>gazebo/command/motor_speed</commandSubTopic><motorNumber>{n}</motorNumber>"
      "<rotorDragCoefficient>8.06428e-05</rotorDragCoefficient><rollingMomentCoefficient>0.000001</"
      "rollingMomentCoefficient>"
      "<motorSpeedPubTopic>motor_speed/{n}</motorSpeedPubTopic><rotorVelocitySlowdownSim>10</"
      "rotorVelocitySlowdownSim>"
      "</plugin></gazebo>\n<gazebo "
      "reference=\"{ns}/rotor_{n}\"><material>Gazebo/Blue</material></gazebo>\n",
      fmt::arg("ns", v.ns), fmt::arg("n", number), fmt::arg("x", r.x), fmt::arg("y", r.y),
      fmt::arg("z", r.z), fmt::arg("parent", r.parent), fmt::arg("m", v.rotor_mass),
      fmt::arg("ixx", v.rotor_ixx), fmt::arg("iyy", v.rotor_iyy), fmt::arg("izz", v.rotor_izz),
      fmt::arg("dir", r.direction), fmt::arg("radius", v.radius), fmt::arg("max", v.max_speed),
      fmt::arg("kf", v.thrust));
}

/// The plain URDF that xacro would make of it.
inline std::string urdf(const StyleVehicle& v) {
  std::string t = fmt::format(
      "<?xml version=\"1.0\" ?>\n<robot name=\"{0}\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n"
      "<link name=\"{0}/base_link\"/>\n"
      "<joint name=\"{0}/base_joint\" type=\"fixed\"><origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>"
      "<parent link=\"{0}/base_link\"/><child link=\"{0}/base_link_inertia\"/></joint>\n"
      "<link name=\"{0}/base_link_inertia\"><inertial><mass value=\"{1}\"/> <!-- [kg] -->"
      "<origin xyz=\"0 0 0\"/><inertia ixx=\"{2}\" ixy=\"0.0\" ixz=\"0.0\" iyy=\"{3}\" iyz=\"0.0\" "
      "izz=\"{4}\"/></inertial>"
      "<visual><origin xyz=\"0 0 0\" rpy=\"0 0 0\"/><geometry>"
      "<mesh filename=\"package://rotors_description/meshes/{0}.dae\" scale=\"1 1 "
      "1\"/></geometry></visual>"
      "<collision><origin xyz=\"0 0 0\" rpy=\"0 0 0\"/><geometry><box size=\"{5} {5} "
      "{6}\"/></geometry></collision></link>\n",
      v.ns, v.mass, v.ixx, v.iyy, v.izz, v.width, v.height);
  const std::string base_plugin = fmt::format(
      "<gazebo><plugin filename=\"librotors_gazebo_multirotor_base_plugin.so\" "
      "name=\"multirotor_base_plugin\">"
      "<robotNamespace>{0}</robotNamespace><linkName>{0}/base_link</"
      "linkName><rotorVelocitySlowdownSim>10</rotorVelocitySlowdownSim>"
      "</plugin></gazebo>\n",
      v.ns);
  t += base_plugin;
  for (std::size_t i = 0; i < v.rotors.size(); ++i) t += rotorElement(v, i);
  t += v.extra;
  t += sensorLink(v.ns, "imu", 0.015);
  t += fmt::format(
      "<gazebo><plugin filename=\"librotors_gazebo_imu_plugin.so\" "
      "name=\"rotors_gazebo_imu_plugin\">"
      "<robotNamespace>{0}</robotNamespace><linkName>{0}/imu_link</linkName><imuTopic>imu</"
      "imuTopic>"
      "<gyroscopeNoiseDensity>0.0003394</gyroscopeNoiseDensity><gyroscopeRandomWalk>0.000038785</"
      "gyroscopeRandomWalk>"
      "<gyroscopeBiasCorrelationTime>1000.0</gyroscopeBiasCorrelationTime>"
      "<gyroscopeTurnOnBiasSigma>0.0087</"
      "gyroscopeTurnOnBiasSigma><accelerometerNoiseDensity>0.004</accelerometerNoiseDensity>"
      "<accelerometerRandomWalk>0.006</accelerometerRandomWalk>"
      "<accelerometerBiasCorrelationTime>300.0</accelerometerBiasCorrelationTime>"
      "<accelerometerTurnOnBiasSigma>0.1960</accelerometerTurnOnBiasSigma></plugin></gazebo>\n",
      v.ns);
  t += sensorLink(v.ns, "odometry_sensor1", 0.00001);
  t += fmt::format(
      "<gazebo><plugin filename=\"librotors_gazebo_odometry_plugin.so\" name=\"odometry_sensor1\">"
      "<linkName>{0}/odometry_sensor1_link</linkName><robotNamespace>{0}</robotNamespace>"
      "<poseTopic>odometry_sensor1/pose</poseTopic>"
      "<poseWithCovarianceTopic>odometry_sensor1/pose_with_covariance</poseWithCovarianceTopic>"
      "<positionTopic>odometry_sensor1/position</positionTopic><transformTopic>odometry_sensor1/"
      "transform</transformTopic>"
      "<odometryTopic>odometry_sensor1/odometry</odometryTopic><parentFrameId>world</parentFrameId>"
      "<childFrameId>{0}/odometry_sensor1</childFrameId><measurementDivisor>1</measurementDivisor>"
      "<measurementDelay>0</measurementDelay><unknownDelay>0.0</unknownDelay>"
      "<noiseNormalPosition>0 0 0</noiseNormalPosition><noiseNormalQuaternion>0 0 "
      "0</noiseNormalQuaternion>"
      "<noiseNormalLinearVelocity>0 0 0</noiseNormalLinearVelocity>"
      "<noiseNormalAngularVelocity>0 0 0</noiseNormalAngularVelocity><noiseUniformPosition>0 0 "
      "0</noiseUniformPosition>"
      "<noiseUniformQuaternion>0 0 0</noiseUniformQuaternion><noiseUniformLinearVelocity>0 0 "
      "0</noiseUniformLinearVelocity>"
      "<noiseUniformAngularVelocity>0 0 0</noiseUniformAngularVelocity></plugin></gazebo>\n",
      v.ns);
  t += fmt::format(
      "<gazebo><plugin name=\"controller_interface\" "
      "filename=\"librotors_gazebo_controller_interface.so\">"
      "<robotNamespace>{0}</robotNamespace><commandAttitudeThrustSubTopic>command/attitude</"
      "commandAttitudeThrustSubTopic>"
      "<commandRateThrustSubTopic>command/rate</commandRateThrustSubTopic>"
      "<commandMotorSpeedSubTopic>command/motor_speed</commandMotorSpeedSubTopic><imuSubTopic>imu</"
      "imuSubTopic>"
      "<motorSpeedCommandPubTopic>gazebo/command/motor_speed</motorSpeedCommandPubTopic></plugin></"
      "gazebo>\n"
      "<gazebo><plugin filename=\"librotors_gazebo_bag_plugin.so\" "
      "name=\"rosbag\"><robotNamespace>{0}</robotNamespace>"
      "<bagFileName>out</bagFileName><linkName>{0}/base_link</linkName><frameId>{0}/base_link</"
      "frameId>"
      "<rotorVelocitySlowdownSim>10</rotorVelocitySlowdownSim><waitToRecordBag>true</"
      "waitToRecordBag></plugin></gazebo>\n",
      v.ns);
  return t + "</robot>\n";
}

constexpr double kThrust = 8.54858e-06, kLargeThrust = 9.9865e-06;

inline StyleVehicle firefly() {
  const double l = 0.215, x = 0.866025403784 * l, y = 0.5 * l, z = 0.037, m = 0.05 / 12;
  return {"firefly",
          1.5,
          0.0347563,
          0.0458929,
          0.0977,
          0.1,
          0.16,
          0.005,
          0.1,
          kThrust,
          838,
          m * (0.015 * 0.015 + 9e-6),
          m * (0.01 + 9e-6),
          m * (0.01 + 0.015 * 0.015),
          {{x, y, z, "ccw"},
           {0, l, z, "cw"},
           {-x, y, z, "ccw"},
           {-x, -y, z, "cw"},
           {0, -l, z, "ccw"},
           {x, -y, z, "cw"}},
          ""};
}

inline StyleVehicle pelican() {
  const double l = 0.21, z = 0.05, m = 0.1 / 12, r2 = 0.128 * 0.128;
  return {"pelican",
          1.0,
          0.01,
          0.01,
          0.02,
          0.1,
          0.2,
          0.01,
          0.128,
          kLargeThrust,
          838,
          m * (0.015 * 0.015 + 9e-6),
          m * (r2 + 9e-6),
          m * (r2 + 0.015 * 0.015),
          {{l, 0, z, "cw"}, {0, l, z, "ccw"}, {-l, 0, z, "cw"}, {0, -l, z, "ccw"}},
          ""};
}

inline StyleVehicle iris() {
  const double z = 0.023, m = 0.05 / 12, d2 = 4 * 0.01;
  return {"iris",
          1.5,
          0.0347563,
          0.0458929,
          0.0977,
          0.47,
          0.11,
          0.005,
          0.1,
          kThrust,
          838,
          m * (0.015 * 0.015 + 9e-6),
          m * (d2 + 9e-6),
          m * (d2 + 0.015 * 0.015),
          {{0.13, -0.22, z, "ccw"},
           {-0.13, 0.2, z, "ccw"},
           {0.13, 0.22, z, "cw"},
           {-0.13, -0.2, z, "cw"}},
          ""};
}

/// Three long arms and a short one, each a link of its own turned about z, the rotors on the arms.
inline StyleVehicle asymmetric() {
  const double l = 0.6, z = 0.03, m = 0.1 / 12, r2 = 0.128 * 0.128;
  StyleVehicle v{"asymmetric_quadrotor",
                 1.0,
                 0.01,
                 0.01,
                 0.02,
                 0.2,
                 0.2,
                 0.01,
                 0.128,
                 kLargeThrust,
                 1000,
                 m * (0.015 * 0.015 + 9e-6),
                 m * (r2 + 9e-6),
                 m * (r2 + 0.015 * 0.015),
                 {{l, 0, z, "ccw", "arm0_link"},
                  {l, 0, z, "cw", "arm1_link"},
                  {l / 3, 0, z, "ccw", "arm2_link"},
                  {l, 0, z, "cw", "arm3_link"}},
                 ""};
  const double yaw[] = {0, 2.0943951023931953, 3.141592653589793, -2.0943951023931953};
  const double length[] = {l, l, l / 3, l},
               mass[] = {(0.01 / 3 + 0.01 * 5 / 9) * 2, 0.01, 0.01 / 3, 0.01};
  for (int i = 0; i < 4; ++i) {
    v.extra += fmt::format(
        "<joint name=\"{0}/arm{1}_joint\" type=\"fixed\"><origin xyz=\"0 0 0\" rpy=\"0 0 {2}\"/>"
        "<parent link=\"{0}/base_link\"/><child link=\"{0}/arm{1}_link\"/></joint>"
        "<link name=\"{0}/arm{1}_link\"><inertial><mass value=\"{3}\"/><origin xyz=\"{4} 0 "
        "0\"/>{5}</inertial>"
        "<collision><origin xyz=\"{4} 0 0\" rpy=\"0 0 0\"/><geometry><box size=\"{6} 0.03 "
        "0.01\"/></geometry></collision></link>\n",
        v.ns, i, yaw[i], mass[i], length[i] / 2, box(mass[i], length[i], 0.03, 0.01), length[i]);
  }
  return v;
}

}  // namespace quad_sim::test
