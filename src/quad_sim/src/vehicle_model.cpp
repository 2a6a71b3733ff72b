#include "quad_sim/vehicle_model.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "quad_sim/plugin.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "urdf_reader.hpp"

namespace quad_sim {
namespace {

using quad_support::ConfigError;
using quad_support::shortest;

/// The text of a URDF and its name, to say where something is wrong.
struct Source {
  const std::string& text;
  const std::string& file;
  [[noreturn]] void fail(const std::string& tag, const std::string& name,
                         const std::string& problem) const {
    throw ConfigError(
        fmt::format("{}: {} '{}': {}", locate(text, file, tag, name), tag, name, problem));
  }
};

template <class Record>
const Record* findByName(const std::vector<Record>& records, const std::string& name) {
  const auto it =
      std::find_if(records.begin(), records.end(), [&](const Record& r) { return r.name == name; });
  return it == records.end() ? nullptr : &*it;
}

bool isPositiveDefinite(const Eigen::Matrix3d& m) {
  return m.allFinite() && m.llt().info() == Eigen::Success;
}

/// No distribution of mass has a principal moment above the sum of the two others; a flat plate has
/// them equal. Returns what is odd about the link, empty if nothing is.
std::string checkPrincipalMoments(const LinkRecord& link, const Source& source) {
  // URDFs print moments to three digits or more: half a unit in the third of each of the three,
  // 5e-4 of the largest, may break the equality of a plate.
  constexpr double kPrinted = 3 * 5e-4;
  // RotorS's Firefly and Iris have moments that break it by 21 %, and must fly; beyond a quarter it
  // is a typing error.
  constexpr double kTolerated = 1.25;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia_L).eigenvalues();
  const double sum = moments[0] + moments[1];
  if (moments[2] <= sum + kPrinted * moments[2]) return "";
  const std::string problem = fmt::format(
      "no body has the principal moments of inertia {:.6g}, {:.6g} and {:.6g} kg m^2: the "
      "largest must be <= the sum of the two others (triangle inequality)",
      moments[0], moments[1], moments[2]);
  if (moments[2] > kTolerated * sum) source.fail("link", link.name, problem);
  return fmt::format("{}: link '{}': {}; taken as it stands",
                     locate(source.text, source.file, "link", link.name), link.name, problem);
}

std::vector<std::string> checkLinks(const UrdfTree& tree, const Source& source) {
  std::vector<std::string> notes;
  for (const LinkRecord& link : tree.links) {
    if (!link.has_inertia) continue;
    if (!isPositiveDefinite(link.inertia_L)) {
      source.fail("link", link.name, "the inertia is not positive definite");
    }
    const std::string note = checkPrincipalMoments(link, source);
    if (!note.empty()) notes.push_back(note);
  }
  return notes;
}

double positive(const PluginDeclaration& p, const std::string& tag, double fallback,
                bool zero_allowed) {
  const double value = p.number(tag, fallback);
  if (zero_allowed ? value < 0 : value <= 0)
    p.fail(tag, zero_allowed ? "must be >= 0" : "must be > 0");
  return value;
}

int motorNumber(const PluginDeclaration& p) {
  const double value = p.number("motorNumber");
  constexpr int kMaxRotors =
      64;  // more than any vehicle has; keeps a typing error from asking for gigabytes
  if (value != std::floor(value) || value < 0 || value >= kMaxRotors) {
    p.fail("motorNumber", fmt::format("must be a whole number in 0..{}", kMaxRotors - 1));
  }
  return static_cast<int>(value);
}

bool isMotor(const PluginDeclaration& p) { return p.filename == "librotors_gazebo_motor_model.so"; }

int spinOf(const PluginDeclaration& p) {
  const std::string direction = p.text("turningDirection", "cw");
  if (direction != "cw" && direction != "ccw") p.fail("turningDirection", "must be cw or ccw");
  return direction == "ccw" ? 1 : -1;
}

/// The numbers of a motor plugin. A tag left out has RotorS's value.
RotorModel readRotorNumbers(const PluginDeclaration& p) {
  RotorModel rotor;
  rotor.motor_number = motorNumber(p);
  rotor.joint = p.text("jointName");
  rotor.link = p.text("linkName");
  rotor.spin = spinOf(p);
  const std::string type = p.text("motorType", "velocity");
  if (type != "velocity")
    p.fail("motorType", "must be velocity: position and force motors are not modelled");
  rotor.thrust_coefficient = positive(p, "motorConstant", 8.54858e-06, false);
  rotor.torque_ratio = positive(p, "momentConstant", 0.016, true);
  rotor.time_constant_up = positive(p, "timeConstantUp", 1.0 / 80.0, false);
  rotor.time_constant_down = positive(p, "timeConstantDown", 1.0 / 40.0, false);
  rotor.max_speed = positive(p, "maxRotVelocity", 838.0, false);
  rotor.drag_coefficient = positive(p, "rotorDragCoefficient", 1.0e-4, true);
  rotor.rolling_moment_coefficient = positive(p, "rollingMomentCoefficient", 1.0e-6, true);
  rotor.slowdown = positive(p, "rotorVelocitySlowdownSim", 10.0, false);
  return rotor;
}

RotorModel readRotor(const PluginDeclaration& p, const UrdfTree& tree) {
  RotorModel rotor = readRotorNumbers(p);
  const JointRecord* joint = findByName(tree.joints, rotor.joint);
  if (!joint) p.fail("jointName", "names no joint of the robot");
  if (!joint->turns) p.fail("jointName", "must name a continuous or revolute joint");
  if (joint->child != rotor.link)
    p.fail("linkName", fmt::format("must be {}, the joint's child", joint->child));
  const LinkRecord* link = findByName(tree.links, rotor.link);
  if (!link || !link->has_inertia) p.fail("linkName", "must name a link with an inertial element");
  rotor.position_B = link->X_BL * link->com_L;
  const Eigen::Vector3d axis_L = joint->axis.normalized();
  rotor.axis_B = link->X_BL.linear() * axis_L;
  rotor.mass = link->mass;
  const double axial = axis_L.dot(link->inertia_L * axis_L);
  rotor.axial_inertia = axial / rotor.slowdown;
  rotor.transverse_inertia = 0.5 * (link->inertia_L.trace() - axial) / rotor.slowdown;
  rotor.disc_radius = link->disc_radius;
  rotor.disc_height = link->disc_height;
  return rotor;
}

/// "motor number 1 is missing: there are 0, 2, 3"; `rotors` by motor number, all different. Empty
/// without a gap.
std::string missingNumber(const std::vector<RotorModel>& rotors) {
  std::string numbers;
  int missing = 0;
  for (const RotorModel& rotor : rotors) {
    if (rotor.motor_number == missing) ++missing;
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(rotor.motor_number);
  }
  if (missing == static_cast<int>(rotors.size())) return "";
  return fmt::format("motor number {} is missing: there are {}", missing, numbers);
}

/// Every freely turning joint needs a motor, and the motors' numbers must be 0, 1, ... without gap.
void checkMotors(const std::vector<RotorModel>& rotors,
                 const std::vector<PluginDeclaration>& plugins, const UrdfTree& tree,
                 const Source& source) {
  const std::string gap = missingNumber(rotors);
  for (const JointRecord& joint : tree.joints) {
    const auto drives = [&](const RotorModel& rotor) { return rotor.joint == joint.name; };
    if (!joint.free || std::any_of(rotors.begin(), rotors.end(), drives)) continue;
    source.fail(
        "joint", joint.name,
        fmt::format(
            "no motor plugin drives it and its link '{}'; {}. Declare one, or make the joint fixed",
            joint.child,
            gap.empty() ? fmt::format("motor numbers 0..{} are other joints'", rotors.size() - 1)
                        : gap));
  }
  if (gap.empty()) return;
  for (const PluginDeclaration& p : plugins) {
    if (!isMotor(p) || motorNumber(p) != rotors.back().motor_number) continue;
    p.fail("motorNumber", fmt::format("leaves a gap: {}; {} rotors are numbered 0..{}", gap,
                                      rotors.size(), rotors.size() - 1));
  }
}

std::vector<RotorModel> readRotors(const std::vector<PluginDeclaration>& plugins,
                                   const UrdfTree& tree, const Source& source) {
  std::vector<RotorModel> rotors;
  for (const PluginDeclaration& p : plugins) {
    if (!isMotor(p)) continue;
    rotors.push_back(readRotor(p, tree));
    for (std::size_t i = 0; i + 1 < rotors.size(); ++i) {
      const RotorModel& other = rotors[i];
      if (other.motor_number == rotors.back().motor_number)
        p.fail("motorNumber", "is taken by joint " + other.joint);
      if (other.link == rotors.back().link) p.fail("linkName", "is driven by another motor plugin");
    }
  }
  if (rotors.empty()) {
    throw ConfigError(source.file +
                      ": no rotor; declare one <gazebo><plugin "
                      "filename=\"librotors_gazebo_motor_model.so\"> each");
  }
  std::sort(rotors.begin(), rotors.end(), [](const RotorModel& a, const RotorModel& b) {
    return a.motor_number < b.motor_number;
  });
  checkMotors(rotors, plugins, tree, source);
  return rotors;
}

SensorModel readSensor(const PluginDeclaration& p, const UrdfTree& tree) {
  SensorModel sensor;
  sensor.declaration = p;
  const bool imu = p.filename == "librotors_gazebo_imu_plugin.so";
  sensor.kind = imu ? SensorModel::Kind::kImu : SensorModel::Kind::kOdometry;
  sensor.link = p.text("linkName");
  const LinkRecord* link = findByName(tree.links, sensor.link);
  if (!link) p.fail("linkName", "names no link of the robot");
  sensor.X_BS = link->X_BL;
  sensor.X_BS.translation() =
      link->X_BL * link->com_L;  // RotorS measures at the link's centre of mass
  sensor.topic = imu ? p.text("imuTopic", "imu") : p.text("odometryTopic", "odometry");
  sensor.frame = imu ? sensor.link : p.text("childFrameId", sensor.link);
  return sensor;
}

/// A link's own inertia about its centre of mass in body axes; a rotor's is the physical one,
/// averaged over a turn.
Eigen::Matrix3d inertiaOf(const LinkRecord& link, const std::vector<RotorModel>& rotors) {
  for (const RotorModel& rotor : rotors) {
    if (rotor.link != link.name) continue;
    return rotor.transverse_inertia * Eigen::Matrix3d::Identity() +
           (rotor.axial_inertia - rotor.transverse_inertia) * rotor.axis_B *
               rotor.axis_B.transpose();
  }
  return link.X_BL.linear() * link.inertia_L * link.X_BL.linear().transpose();
}

/// Inertia of a point mass about the origin, Steiner's term.
Eigen::Matrix3d steiner(double mass, const Eigen::Vector3d& r) {
  return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
}

/// Sums mass, first moment and inertia about base_link's origin, then moves to the centre of mass.
void sumUp(const UrdfTree& tree, std::optional<double> total_mass, const std::string& file,
           VehicleModel& model) {
  double mass = 0, base_mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const LinkRecord& link : tree.links) {
    if (!link.has_inertia) continue;
    const Eigen::Vector3d r = link.X_BL * link.com_L;
    mass += link.mass;
    base_mass += link.on_base ? link.mass : 0;
    moment += link.mass * r;
    inertia += inertiaOf(link, model.rotors) + steiner(link.mass, r);
  }
  if (total_mass) {  // a point mass at base_link's origin: adds to neither the first moment nor the
                     // inertia about it
    if (!(*total_mass > 0) || !(base_mass + *total_mass - mass > 0)) {
      throw ConfigError(
          fmt::format("{}: total mass {} kg; must be > {:.6g} kg, what the links beside {} weigh",
                      file, shortest(*total_mass), mass - base_mass, tree.base_link));
    }
    mass = *total_mass;
  }
  if (!(mass > 0)) throw ConfigError(file + ": no link has a mass");
  model.mass = mass;
  model.com_B = moment / mass;
  model.inertia_B = inertia - steiner(mass, model.com_B);
  model.inertia_B = (0.5 * (model.inertia_B + model.inertia_B.transpose())).eval();
  if (!isPositiveDefinite(model.inertia_B)) {
    throw ConfigError(file +
                      ": the vehicle's inertia about its centre of mass is not positive definite");
  }
}

std::string jointTo(const std::string& link, const UrdfTree& tree) {
  for (const JointRecord& joint : tree.joints) {
    if (joint.child == link) return joint.name;
  }
  return "";
}

}  // namespace

VehicleModel parseVehicle(const std::string& urdf_text, const std::string& name,
                          std::optional<double> total_mass) {
  const Source source{urdf_text, name};
  VehicleModel model;
  model.plugins = readPlugins(urdf_text, name);  // first: it says the line of malformed XML
  checkInertials(urdf_text, name);
  const UrdfTree tree = readTree(urdf_text, name);
  model.name = tree.robot;
  model.base_link = tree.base_link;
  model.notes = checkLinks(tree, source);
  for (const PluginDeclaration& p : model.plugins) {
    if (pluginRole(p) == PluginRole::kSensor) model.sensors.push_back(readSensor(p, tree));
  }
  model.rotors = readRotors(model.plugins, tree, source);
  sumUp(tree, total_mass, name, model);
  for (const LinkRecord& link : tree.links) {
    model.links.push_back({link.name, jointTo(link.name, tree), link.on_base, link.mass, link.X_BL,
                           link.com_L, link.inertia_L});
    if (!link.on_base) continue;
    for (const CollisionBox& box : link.boxes) {
      if (!(box.size.minCoeff() > 0))
        source.fail("link", link.name, "a collision box has a side that is not > 0");
      model.boxes.push_back({box.size, link.X_BL * box.X_BC});
    }
  }
  return model;
}

VehicleModel loadVehicle(const std::string& urdf_path, std::optional<double> total_mass) {
  return parseVehicle(quad_support::readFile(urdf_path), urdf_path, total_mass);
}

double hoverSpeed(const VehicleModel& model, double gravity) {
  double lift = 0, max_speed = std::numeric_limits<double>::infinity();
  for (const RotorModel& rotor : model.rotors) {
    lift += rotor.thrust_coefficient * rotor.axis_B.z();
    max_speed = std::min(max_speed, rotor.max_speed);
  }
  if (!(lift > 0))
    throw std::invalid_argument(model.name +
                                ": the rotors' thrust does not point up, so it cannot hover");
  const double speed = std::sqrt(model.mass * gravity / lift);
  if (speed > max_speed) {
    throw std::invalid_argument(
        fmt::format("{}: hovering with {} kg takes {:.6g} rad/s, but the rotors turn at most {} "
                    "rad/s, which carries {:.4g} kg",
                    model.name, shortest(model.mass), speed, shortest(max_speed),
                    lift * max_speed * max_speed / gravity));
  }
  return speed;
}

VehicleState equilibrium(const VehicleModel& model, double gravity, double altitude) {
  VehicleState state;
  state.p_WB.z() = altitude;
  state.rotor_speed.assign(model.rotors.size(), hoverSpeed(model, gravity));
  return state;
}

}  // namespace quad_sim
