#include "ode_world.hpp"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <mutex>
#include <stdexcept>

#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A thread's own collision caches; nothing if they are there.
void initThread() { dAllocateODEDataForThread(dAllocateMaskAll); }

void initOde() {
  static std::once_flag once;
  std::call_once(once, [] { dInitODE2(0); });
  initThread();
}

}  // namespace

OdeWorld::OdeWorld() {
  initOde();
  world = dWorldCreate();
  threading =
      dThreadingAllocateSelfThreadedImplementation();  // ODE's default one is shared by all worlds
  dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(threading),
                                       threading);
  dWorldSetERP(world, 0.2);  // RotorS's world: erp 0.2, cfm 0
  dWorldSetCFM(world, 0.0);
  dWorldSetContactSurfaceLayer(world, kContactLayer);
  dWorldSetContactMaxCorrectingVel(world, 100.0);
  dWorldSetQuickStepNumIterations(world, 50);
  body = dBodyCreate(world);
  dBodySetGyroscopicMode(body, 0);  // gyroscopic torques are ours, see RigidBody and HingedBody
  position = dBodyGetPosition(body);
  rotation = dBodyGetRotation(body);
}

OdeWorld::~OdeWorld() {
  for (dGeomID box : boxes) dGeomDestroy(box);
  if (plane) dGeomDestroy(plane);
  if (contacts) dJointGroupDestroy(contacts);
  if (world) dWorldDestroy(world);
  if (threading) dThreadingFreeImplementation(threading);
}

void OdeWorld::makeGround() {
  contacts = dJointGroupCreate(0);
  plane = dCreatePlane(nullptr, 0, 0, 1, kContactLayer);
}

int OdeWorld::touch(dGeomID geom, dBodyID of) {
  initThread();  // who steps need not be who built this
  std::array<dContactGeom, kMaxContacts> found;
  const int n = dCollide(geom, plane, kMaxContacts, found.data(), sizeof(dContactGeom));
  for (int k = 0; k < n; ++k) {
    dContact contact{};
    contact.surface.mu = 1.0;  // Gazebo's default friction
    contact.geom = found[static_cast<std::size_t>(k)];
    dJointAttach(dJointCreateContact(world, contacts, &contact), of, nullptr);
  }
  return n;
}

void OdeWorld::quickStep(double h) {
  // QuickStep draws the order of the constraints from a generator that is one for the process,
  // while worlds may step in several threads.
  static std::mutex order_of_constraints;
  const std::lock_guard<std::mutex> lock(order_of_constraints);
  dRandSetSeed(0);
  // Not dWorldStep: its direct solver breaks down on a box's four corners, which say one thing
  // twice.
  dWorldQuickStep(world, h);
  dJointGroupEmpty(contacts);
}

void checkReach(double reach) {
  constexpr double kFarthest = 1e4;  // [m]
  if (reach <= kFarthest) return;
  throw std::invalid_argument(fmt::format(
      "a rotor or a collision geometry reaches {} m from the centre of mass; must be <= {} m",
      quad_support::shortest(reach), kFarthest));
}

void checkContactSpeed(const Vector3d& v_W) {
  constexpr double kFastest = 1e6;  // [m/s]
  if (v_W.squaredNorm() <= kFastest * kFastest) return;
  throw quad_support::SimulationError(
      fmt::format("the body hits the ground at {} m/s", quad_support::shortest(v_W.norm())));
}

void coast(dBodyID body, const Vector3d& v_W, const Vector3d& w_W, double h) {
  const dReal* p = dBodyGetPosition(body);
  dBodySetPosition(body, p[0] + h * v_W.x(), p[1] + h * v_W.y(), p[2] + h * v_W.z());
  const dReal* q = dBodyGetQuaternion(body);
  const dVector3 w = {w_W.x(), w_W.y(), w_W.z()};
  dQuaternion rate;
  dDQfromW(rate, w, q);
  const dQuaternion turned = {q[0] + h * rate[0], q[1] + h * rate[1], q[2] + h * rate[2],
                              q[3] + h * rate[3]};
  dBodySetQuaternion(body, turned);  // normalises, makes the matrix
}

Vector3d positionOf(dBodyID body) {
  const dReal* p = dBodyGetPosition(body);
  return Vector3d(p[0], p[1], p[2]);
}

Matrix3d rotationOf(dBodyID body) { return MatrixInOde(dBodyGetRotation(body)).leftCols<3>(); }

void setPose(dGeomID geom, const Vector3d& p, const Matrix3d& R) {
  const dMatrix3 R_ode = {R(0, 0), R(0, 1), R(0, 2), 0,       R(1, 0), R(1, 1),
                          R(1, 2), 0,       R(2, 0), R(2, 1), R(2, 2), 0};
  dGeomSetPosition(geom, p.x(), p.y(), p.z());
  dGeomSetRotation(geom, R_ode);
}

void setMass(dBodyID body, const std::string& part, double mass, const Matrix3d& I) {
  // From a grain of dust to a ship: far from any vehicle, near enough for ODE's products and
  // quotients of such numbers.
  constexpr double kSmallest = 1e-15, kLargest = 1e9, kThinnest = 1e-9;
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvalues();
  const bool sound = mass > kSmallest && mass < kLargest && moments[0] > kSmallest &&
                     moments[2] < kLargest && moments[0] > kThinnest * moments[2];
  if (!sound) {
    throw std::invalid_argument(fmt::format(
        "{}: a body of {} kg with moments of inertia {}, {} and {} kg m^2 cannot be moved; masses "
        "and moments must lie in ({}, {}) and the least moment above {} times the largest",
        part, quad_support::shortest(mass), quad_support::shortest(moments[0]),
        quad_support::shortest(moments[1]), quad_support::shortest(moments[2]), kSmallest, kLargest,
        kThinnest));
  }
  dMass m;
  dMassSetParameters(&m, mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  dBodySetMass(body, &m);
}

}  // namespace quad_sim
