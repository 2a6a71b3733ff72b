/// A rotor's own body and its hinge, for the two files of HingedBody. Not installed.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "hinged_body.hpp"
#include "ode_world.hpp"

namespace quad_sim {

/// Inertia of a point mass about the origin, Steiner's term.
inline Eigen::Matrix3d steiner(double mass, const Eigen::Vector3d& r) {
  return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
}

inline Eigen::Vector3d linearVelocity(dBodyID body) {
  const dReal* v = dBodyGetLinearVel(body);
  return Eigen::Vector3d(v[0], v[1], v[2]);
}
inline Eigen::Vector3d angularVelocity(dBodyID body) {
  const dReal* w = dBodyGetAngularVel(body);
  return Eigen::Vector3d(w[0], w[1], w[2]);
}
inline void setVelocity(dBodyID body, const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
  dBodySetLinearVel(body, v.x(), v.y(), v.z());
  dBodySetAngularVel(body, w.x(), w.y(), w.z());
}

inline Eigen::Quaterniond orientationOf(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}
inline void place(dBodyID body, const Eigen::Vector3d& p, const Eigen::Quaterniond& q) {
  const dQuaternion q_ode = {q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(body, p.x(), p.y(), p.z());
  dBodySetQuaternion(body, q_ode);
}

struct HingedBody::Rotor {
  dBodyID body;
  dJointID hinge;
  dGeomID disc;  ///< nullptr: it touches nothing
  double mass;
  double axial, transverse;  ///< inertia [kg m²] as the hinge feels it
  double spin_per_speed;     ///< hinge speed over rotor speed: the spin's sign, slowed down or not
  Eigen::Vector3d hub_B;     ///< from the base's centre of mass
  Eigen::Vector3d axis_B;
  Eigen::Quaterniond rest_B;  ///< body to base at angle 0: the body's z is the axis
  Eigen::Vector3d axis_W() const { return orientationOf(body) * Eigen::Vector3d::UnitZ(); }
};

}  // namespace quad_sim
