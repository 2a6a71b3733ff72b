#include "rigid_body.hpp"

#include <fmt/core.h>
#include <ode/ode.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using MatrixInOde = Eigen::Map<const Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>>;

constexpr int kMaxContactsPerBox = 8;  // a box's corners
/// The contact plane stands this much above z = 0 and lets bodies sink as much: a resting body then touches in
/// every step, instead of falling and being lifted in turns, and rests at z = 0 exactly.
constexpr double kContactLayer = 1e-5;  // [m]

void initOde() {
  static std::once_flag once;
  std::call_once(once, [] { dInitODE2(0); });
  dAllocateODEDataForThread(dAllocateMaskAll);  // each thread's collision caches; nothing if they are there
}

}  // namespace

struct RigidBody::Ode {
  dThreadingImplementationID threading = nullptr;  ///< of this world alone, so that worlds may step in several threads
  dWorldID world = nullptr;
  dBodyID body = nullptr;
  dJointGroupID contacts = nullptr;
  dGeomID plane = nullptr;
  std::vector<dGeomID> boxes;  ///< beside the body, moved to it only near the ground
  const dReal* position = nullptr;
  const dReal* rotation = nullptr;

  Ode() = default;
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;
  ~Ode() {
    for (dGeomID box : boxes) dGeomDestroy(box);
    if (plane) dGeomDestroy(plane);
    if (contacts) dJointGroupDestroy(contacts);
    if (world) dWorldDestroy(world);
    if (threading) dThreadingFreeImplementation(threading);
  }
  Vector3d p() const { return Vector3d(position[0], position[1], position[2]); }
  Matrix3d R() const { return MatrixInOde(rotation).leftCols<3>(); }
};

RigidBody::RigidBody(const VehicleModel& model, double step, double gravity, bool ground)
    : h_(step),
      gravity_(gravity),
      mass_(model.mass),
      com_B_(model.com_B),
      inertia_(model.inertia_B),
      inverse_inertia_(model.inertia_B.inverse()),
      ode_(std::make_unique<Ode>()) {
  initOde();
  Ode& ode = *ode_;
  ode.world = dWorldCreate();
  ode.threading = dThreadingAllocateSelfThreadedImplementation();  // ODE's default one is shared by all worlds
  dWorldSetStepThreadingImplementation(ode.world, dThreadingImplementationGetFunctions(ode.threading), ode.threading);
  dWorldSetERP(ode.world, 0.2);  // RotorS's world: erp 0.2, cfm 0
  dWorldSetCFM(ode.world, 0.0);
  dWorldSetContactSurfaceLayer(ode.world, kContactLayer);
  dWorldSetContactMaxCorrectingVel(ode.world, 100.0);
  dWorldSetQuickStepNumIterations(ode.world, 50);
  ode.body = dBodyCreate(ode.world);
  ode.position = dBodyGetPosition(ode.body);
  ode.rotation = dBodyGetRotation(ode.body);
  dMass mass;
  dMassSetParameters(&mass, mass_, 0, 0, 0, inertia_(0, 0), inertia_(1, 1), inertia_(2, 2), inertia_(0, 1),
                     inertia_(0, 2), inertia_(1, 2));
  dBodySetMass(ode.body, &mass);
  dBodySetGravityMode(ode.body, 0);     // gravity comes with the other forces
  dBodySetGyroscopicMode(ode.body, 0);  // see the class comment
  ode.contacts = dJointGroupCreate(0);
  if (!ground || model.boxes.empty()) return;
  ode.plane = dCreatePlane(nullptr, 0, 0, 1, kContactLayer);
  boxes_ = model.boxes;
  for (CollisionBox& box : boxes_) {
    ode.boxes.push_back(dCreateBox(nullptr, box.size.x(), box.size.y(), box.size.z()));
    box.X_BC.translation() -= com_B_;  // from here on relative to C
    reach_ = std::max(reach_, box.X_BC.translation().norm() + 0.5 * box.size.norm() + 2 * kContactLayer);
  }
}

RigidBody::~RigidBody() = default;

void RigidBody::refreshBodyRates(const Vector3d& momentum_B) {
  const Matrix3d R = ode_->R();
  v_C_B_ = R.transpose() * v_W_;
  Pi_B_ = R.transpose() * L_W_;
  w_B_ = inverse_inertia_ * (Pi_B_ - momentum_B);
}

void RigidBody::restore(const VehicleState& state, const Vector3d& momentum_B) {
  const Eigen::Quaterniond q = state.q_WB.normalized();
  const dQuaternion q_ode = {q.w(), q.x(), q.y(), q.z()};
  dBodySetQuaternion(ode_->body, q_ode);
  const Matrix3d R = ode_->R();
  const Vector3d p = state.p_WB + R * com_B_;
  dBodySetPosition(ode_->body, p.x(), p.y(), p.z());
  dBodySetForce(ode_->body, 0, 0, 0);
  dBodySetTorque(ode_->body, 0, 0, 0);
  v_W_ = state.v_WB + R * state.w_WB_B.cross(com_B_);
  L_W_ = R * (inertia_ * state.w_WB_B + momentum_B);
  refreshBodyRates(momentum_B);
  v_before_W_ = v_W_;
  w_before_B_ = w_B_;
}

void RigidBody::save(VehicleState& state) const {
  const dReal* q = dBodyGetQuaternion(ode_->body);
  const Matrix3d R = ode_->R();
  state.q_WB = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  state.p_WB = ode_->p() - R * com_B_;
  state.w_WB_B = w_B_;
  state.v_WB = v_W_ - R * w_B_.cross(com_B_);
}

void RigidBody::archive(StateArchive& archive) {
  // Past ODE's setters: dBodySetQuaternion() normalises anew, which moves the last bit. What the getters point to is the
  // body's own storage.
  archive(const_cast<dReal*>(dBodyGetPosition(ode_->body)), 3);
  archive(const_cast<dReal*>(dBodyGetQuaternion(ode_->body)), 4);
  archive(const_cast<dReal*>(dBodyGetRotation(ode_->body)), 12);
  for (Vector3d* v : {&v_W_, &L_W_, &v_C_B_, &w_B_, &Pi_B_, &v_before_W_, &w_before_B_}) archive(*v);
}

void RigidBody::motion(StepInput& input) const {
  input.v_WC_B = v_C_B_;
  input.w_WB_B = w_B_;
  input.p_WC = ode_->p();
  input.R_WB = ode_->R();
}

Vector3d RigidBody::specificForce(const Vector3d& r_C) const {
  // a_P = a_C + alpha x r + w x (w x r), with means over the step for the first two and the rate at its end for the third.
  const Vector3d a_W = (v_W_ - v_before_W_) / h_ + Vector3d(0, 0, gravity_);
  const Vector3d alpha = (w_B_ - w_before_B_) / h_;
  return ode_->R().transpose() * a_W + alpha.cross(r_C) + w_B_.cross(w_B_.cross(r_C));
}

bool RigidBody::isFinite() const { return ode_->p().allFinite() && v_W_.allFinite() && L_W_.allFinite(); }

namespace {

/// tan(y)/y for y = h|w|/2. ODE's step q + (h/2) w q, normalised, turns by 2 atan(h|w|/2); with w stretched by this
/// factor it turns by h|w|. The series is exact to rounding up to h|w| = 0.04 and to 1e-5 at h|w| = 1.
double rateStretch(double half_angle_squared) {
  const double y2 = half_angle_squared;
  return 1.0 + y2 * (1.0 / 3.0 + y2 * (2.0 / 15.0 + y2 * (17.0 / 315.0 + y2 * (62.0 / 2835.0))));
}

}  // namespace

Vector3d RigidBody::midpointRate(const Vector3d& Pi, const Vector3d& momentum_B, double a) const {
  constexpr int kMaxIterations = 30;   // the error shrinks by h|w|/2 each time: 5 at 15 rad/s and 1 ms, 1 in hover
  constexpr double kEnough = 1e-26;    // square of the change relative to the rate
  Vector3d w = w_B_;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Vector3d Pi_mid = Pi + a * (inertia_ * w + momentum_B).cross(w);
    const Vector3d next = inverse_inertia_ * (Pi_mid - momentum_B);
    const double change = (next - w).squaredNorm();
    w = next;
    if (change <= kEnough * w.squaredNorm()) break;
  }
  return w;
}

void RigidBody::checkRate(const Vector3d& w) const {
  // Beyond a radian a step nothing is resolved any more, and ODE ends the process on a turn that is not finite.
  if (h_ * h_ * w.squaredNorm() <= 1.0) return;
  throw quad_support::SimulationError(
      fmt::format("the body turns at {} rad/s, more than a radian in a step", quad_support::shortest(w.norm())));
}

bool RigidBody::step(const StepLoad& load) {
  const Matrix3d R = ode_->R();
  v_before_W_ = v_W_;
  w_before_B_ = w_B_;
  if (reach_ >= 0 && ode_->position[2] < reach_ && collide(R) > 0) {
    stepInContact(R, load);
    return true;
  }
  // Half the torque acts before the turn, so that the midpoint is one of the torque as well.
  const double half = 0.5 * h_;
  const double stretch = rateStretch(half * half * w_B_.squaredNorm());
  const Vector3d w = midpointRate(Pi_B_ + half * load.torque_B, load.momentum_mean_B, half * stretch);
  checkRate(w);
  // Body-fixed loads as seen from W in the middle of the step: R_mid = R (1 + (h/2) [w]x) to second order.
  const Vector3d turn = half * w;
  Vector3d dv = R * (h_ / mass_ * (load.force_B + turn.cross(load.force_B)));
  dv.z() -= h_ * gravity_;
  const Vector3d v_mid = v_W_ + 0.5 * dv;
  const Vector3d w_W = R * (stretch * w);
  dBodySetLinearVel(ode_->body, v_mid.x(), v_mid.y(), v_mid.z());
  dBodySetAngularVel(ode_->body, w_W.x(), w_W.y(), w_W.z());
  dWorldStep(ode_->world, h_);
  v_W_ += dv;
  L_W_ += R * (h_ * (load.torque_B + turn.cross(load.torque_B)));
  refreshBodyRates(load.momentum_end_B);
  return false;
}

/// In contact all of the force acts before the step (semi-implicit Euler, as ODE does it), for the solver must see it.
void RigidBody::stepInContact(const Matrix3d& R, const StepLoad& load) {
  v_W_ += (h_ / mass_) * (R * load.force_B) - Vector3d(0, 0, h_ * gravity_);
  const Vector3d w_B = inverse_inertia_ * (Pi_B_ + h_ * load.torque_B - load.momentum_end_B);
  checkRate(w_B);
  const Vector3d w_W = R * w_B;
  dBodySetLinearVel(ode_->body, v_W_.x(), v_W_.y(), v_W_.z());
  dBodySetAngularVel(ode_->body, w_W.x(), w_W.y(), w_W.z());
  dRandSetSeed(0);  // QuickStep draws the order of the constraints from a generator that is one for the process
  // Not dWorldStep: its direct solver breaks down on a box's four corners, which say one thing twice.
  dWorldQuickStep(ode_->world, h_);
  dJointGroupEmpty(ode_->contacts);
  const dReal* v = dBodyGetLinearVel(ode_->body);
  const dReal* w = dBodyGetAngularVel(ode_->body);
  const Matrix3d R_end = ode_->R();
  v_W_ = Vector3d(v[0], v[1], v[2]);
  const Vector3d w_end_B = R_end.transpose() * Vector3d(w[0], w[1], w[2]);
  L_W_ = R_end * (inertia_ * w_end_B + load.momentum_end_B);
  refreshBodyRates(load.momentum_end_B);
}

int RigidBody::collide(const Matrix3d& R_WB) {
  Ode& ode = *ode_;
  int count = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const Vector3d p = ode.p() + R_WB * boxes_[i].X_BC.translation();
    const Matrix3d R = R_WB * boxes_[i].X_BC.linear();
    const dMatrix3 R_ode = {R(0, 0), R(0, 1), R(0, 2), 0, R(1, 0), R(1, 1), R(1, 2), 0, R(2, 0), R(2, 1), R(2, 2), 0};
    dGeomSetPosition(ode.boxes[i], p.x(), p.y(), p.z());
    dGeomSetRotation(ode.boxes[i], R_ode);
    std::array<dContactGeom, kMaxContactsPerBox> touch;
    const int n = dCollide(ode.boxes[i], ode.plane, kMaxContactsPerBox, touch.data(), sizeof(dContactGeom));
    for (int k = 0; k < n; ++k) {
      dContact contact{};
      contact.surface.mu = 1.0;  // Gazebo's default friction
      contact.geom = touch[static_cast<std::size_t>(k)];
      dJointAttach(dJointCreateContact(ode.world, ode.contacts, &contact), ode.body, nullptr);
    }
    count += n;
  }
  return count;
}

}  // namespace quad_sim
