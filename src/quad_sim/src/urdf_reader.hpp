/// What the two readers of a URDF hand to loadVehicle(). Not installed.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

/// A link with an inertial element.
struct LinkRecord {
  std::string name;
  bool on_base = false;  ///< joined to base_link by fixed joints only
  bool has_inertia = false;
  double mass = 0;
  Eigen::Isometry3d X_BL = Eigen::Isometry3d::Identity();  ///< link in base_link, joints at zero
  Eigen::Vector3d com_L = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_L =
      Eigen::Matrix3d::Zero();              ///< about the link's centre of mass, link axes
  std::vector<CollisionBox> boxes;          ///< with X_BC in link axes
  double disc_radius = 0, disc_height = 0;  ///< of a collision cylinder [m]; 0: none
};

struct JointRecord {
  std::string name, child;
  bool turns = false;                               ///< continuous or revolute
  bool free = false;                                ///< continuous: turns without end, as rotors do
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< in the child's axes
};

struct UrdfTree {
  std::string robot, base_link;
  std::vector<LinkRecord> links;    ///< by name
  std::vector<JointRecord> joints;  ///< by name
};

/// Reads links and joints (urdfdom). base_link is the link of that name, or the one whose name ends
/// in "/base_link", or the root.
/// @throws quad_support::ConfigError with urdfdom's complaint
UrdfTree readTree(const std::string& urdf_text, const std::string& file);

/// Reads the `<gazebo><plugin>` and `<gazebo><sensor><plugin>` elements (tinyxml2), which urdfdom
/// skips. @throws quad_support::ConfigError
std::vector<PluginDeclaration> readPlugins(const std::string& urdf_text, const std::string& file);

/// Checks that the mass and the inertia of every link are finite numbers and the mass is positive.
/// To be called before readTree(): urdfdom takes what is no number for zero and knows no lines.
/// @throws quad_support::ConfigError with file, line, link and the text found
void checkInertials(const std::string& urdf_text, const std::string& file);

/// "file:line" of the element with that tag and name attribute, or just the file.
std::string locate(const std::string& urdf_text, const std::string& file, const std::string& tag,
                   const std::string& name);

}  // namespace quad_sim
