/// An ODE world with a ground plane and a body, ended when it goes. The one file that includes ODE.
/// Not installed.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace quad_sim {

/// The contact plane stands this much above z = 0 and lets bodies sink as much: a resting body then
/// touches in every step, instead of falling and being lifted in turns, and rests at z = 0 exactly.
constexpr double kContactLayer = 1e-5;  // [m]
constexpr int kMaxContacts = 8;         // a box's corners

using MatrixInOde = Eigen::Map<const Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>>;

struct OdeWorld {
  dThreadingImplementationID threading =
      nullptr;  ///< of this world alone, so that worlds may step in several threads
  dWorldID world = nullptr;
  dBodyID body = nullptr;
  dJointGroupID contacts = nullptr;
  dGeomID plane = nullptr;
  std::vector<dGeomID> boxes;  ///< beside the body, moved to it only near the ground
  const dReal* position = nullptr;
  const dReal* rotation = nullptr;

  OdeWorld();  ///< world and body; no gravity, RotorS's contact parameters
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  Eigen::Vector3d p() const { return Eigen::Vector3d(position[0], position[1], position[2]); }
  Eigen::Matrix3d R() const { return MatrixInOde(rotation).leftCols<3>(); }

  void makeGround();
  /// Contact joints between a geometry and the ground, for the step to come; returns how many.
  int touch(dGeomID geom, dBodyID of);
  /// One step of QuickStep; removes the contacts.
  void quickStep(double h);
};

/// Moves a body that nothing touches and no joint holds for `h` [s] with a velocity [m/s] and a
/// rate [rad/s], both in W: to the last bit what dWorldStep() does with it, without the search for
/// islands, the arena and the jobs of a solver that has nothing to solve (docs/design/0009).
void coast(dBodyID body, const Eigen::Vector3d& v_W, const Eigen::Vector3d& w_W, double h);
Eigen::Vector3d positionOf(dBodyID body);
Eigen::Matrix3d rotationOf(dBodyID body);
void setPose(dGeomID geom, const Eigen::Vector3d& p, const Eigen::Matrix3d& R);
/// @throws std::invalid_argument naming the part if its mass or inertia is too small, too large or
/// too thin for ODE, which would end the process
void setMass(dBodyID body, const std::string& part, double mass, const Eigen::Matrix3d& inertia);

/// ODE ends the process on what is not finite, so what would become so in a contact is refused
/// before.
/// @throws std::invalid_argument if `reach` [m] from the centre of mass is no size of a vehicle
void checkReach(double reach);
/// @throws quad_support::SimulationError if the velocity [m/s] is not one to solve contacts with
void checkContactSpeed(const Eigen::Vector3d& v_W);

}  // namespace quad_sim
