/// A vehicle as its URDF describes it: rigid-body totals, rotors, sensors, and the plugins it asks
/// for.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "quad_sim/quirks.hpp"
#include "quad_sim/state.hpp"

namespace quad_sim {

/// A `<gazebo><plugin filename="…">` element: the plugin's library, and its settings as text by
/// tag.
struct PluginDeclaration {
  std::string filename;                     ///< "librotors_gazebo_motor_model.so"
  std::string name;                         ///< the element's name attribute
  std::string where;                        ///< "file:line", for messages
  std::map<std::string, std::string> tags;  ///< "motorConstant" -> "8.54858e-06"

  /// @throws quad_support::ConfigError naming file, line and tag
  const std::string& text(const std::string& tag) const;
  std::string text(const std::string& tag, const std::string& fallback) const;
  double number(const std::string& tag) const;  ///< a finite number
  double number(const std::string& tag, double fallback) const;
  Eigen::Vector3d vector(
      const std::string& tag) const;  ///< three finite numbers with spaces between
  Eigen::Vector3d vector(const std::string& tag, const Eigen::Vector3d& fallback) const;
  [[noreturn]] void fail(const std::string& tag, const std::string& problem) const;
};

/// One rotor. Thrust k_f w² along its axis and drag torque k_f w² * torque_ratio against its spin:
/// thesis Eq. (1.1).
struct RotorModel {
  int motor_number = 0;
  std::string link, joint;
  Eigen::Vector3d position_B;  ///< hub [m], from base_link's origin
  Eigen::Vector3d axis_B;      ///< unit vector of positive thrust
  int spin = 1;                ///< +1 counter-clockwise seen from the tip of axis_B, -1 clockwise
  double thrust_coefficient = 0;                        ///< k_f [N s²/rad²]
  double torque_ratio = 0;                              ///< k_m / k_f [m] (RotorS's momentConstant)
  double time_constant_up = 0, time_constant_down = 0;  ///< of the speed's first-order lag [s]
  double max_speed = 0;                                 ///< [rad/s]
  double drag_coefficient = 0;                          ///< H-force: -|w| c v_perp [N s²/(m rad)]
  double rolling_moment_coefficient = 0;                ///< -s |w| c v_perp [N s²/rad]
  double slowdown =
      1;  ///< RotorS's joints turn this much slower, and its rotor inertias are as much larger
  double mass = 0;                          ///< [kg]
  double axial_inertia = 0;                 ///< about axis_B [kg m²], physical (URDF's / slowdown)
  double transverse_inertia = 0;            ///< mean of the two others, physical
  double disc_radius = 0, disc_height = 0;  ///< collision cylinder about the axis [m]; 0: none
};

/// A sensor's frame and what it is called on the outside.
struct SensorModel {
  enum class Kind { kOdometry, kImu } kind = Kind::kOdometry;
  std::string link;   ///< the link it sits on
  std::string topic;  ///< relative to the vehicle's namespace, e.g. "odometry_sensor1/odometry"
  std::string frame;  ///< the message's child frame, e.g. "hummingbird/odometry_sensor1"
  Eigen::Isometry3d X_BS = Eigen::Isometry3d::Identity();  ///< sensor in base_link
  PluginDeclaration declaration;
};

/// A box fixed to base_link that may touch the ground.
struct CollisionBox {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< full lengths [m]
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
};

/// A link as the URDF has it.
struct LinkModel {
  std::string name;
  std::string joint;     ///< that joins it to its parent; empty at the root
  bool on_base = false;  ///< joined to base_link by fixed joints only
  double mass = 0;       ///< [kg]
  Eigen::Isometry3d X_BL = Eigen::Isometry3d::Identity();  ///< link in base_link, joints at zero
  Eigen::Vector3d com_L = Eigen::Vector3d::Zero();         ///< [m]
  Eigen::Matrix3d inertia_L =
      Eigen::Matrix3d::Zero();  ///< about its centre of mass, its axes [kg m²]
};

/// The vehicle, with its links joined to one body at their URDF positions.
///
/// Rotors count with their mass and their physical inertia, the transverse part averaged over a
/// turn, so `inertia` is that of the whole vehicle with the rotors not turning relative to it.
struct VehicleModel {
  std::string name;                ///< of the robot
  std::string base_link;           ///< name of B's link
  double mass = 0;                 ///< [kg]
  Eigen::Vector3d com_B;           ///< centre of mass [m], from base_link's origin
  Eigen::Matrix3d inertia_B;       ///< about the centre of mass, body axes [kg m²]
  std::vector<RotorModel> rotors;  ///< by motor number, without gaps
  std::vector<SensorModel> sensors;
  std::vector<CollisionBox> boxes;  ///< of the links fixed to base_link; none: no ground contact
  std::vector<PluginDeclaration> plugins;  ///< all, in the order of the file
  std::vector<LinkModel> links;            ///< from the root outwards
  std::vector<std::string>
      notes;  ///< "file:line: …", what is odd about it and taken as it stands. Tell the user, once
};

/// Reads a plain URDF (xacro expanded).
/// @param total_mass  [kg]; the difference to the URDF's total is put on base_link's origin.
/// nullopt keeps the URDF's
/// @throws std::invalid_argument if the file cannot be read, quad_support::ConfigError (file:line,
/// link or tag,
///         problem) for a model that cannot fly: no rotor, a freely turning joint without motor,
///         motor numbers with a gap or twice, mass or inertia that is no number, not positive or of
///         no body, unknown plugin (lists the known ones), …
VehicleModel loadVehicle(const std::string& urdf_path,
                         std::optional<double> total_mass = std::nullopt);

/// The same from text; `name` stands for the file in messages.
VehicleModel parseVehicle(const std::string& urdf_text, const std::string& name,
                          std::optional<double> total_mass = std::nullopt);

/// The equal speed [rad/s] of all rotors that carries mass * gravity with the vehicle level.
/// @throws std::invalid_argument if the rotors' thrust does not point up, or max_speed does not
/// suffice
double hoverSpeed(const VehicleModel& model, double gravity);

/// At rest and level at `altitude` [m] of base_link's origin, rotors at hoverSpeed().
VehicleState equilibrium(const VehicleModel& model, double gravity, double altitude);

}  // namespace quad_sim
