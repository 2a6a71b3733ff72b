#include "rigid_body.hpp"

#include <fmt/core.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ode_world.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The vehicle's inertia with its rotors as RotorS weighs them: with the URDF's inertia, `slowdown`
/// times the physical one, and free about their axes, so that the share about the axis turns
/// nothing.
Matrix3d inertiaOfRotorS(const VehicleModel& model) {
  Matrix3d inertia = model.inertia_B;
  for (const RotorModel& r : model.rotors) {
    const Matrix3d axial = r.axis_B * r.axis_B.transpose();
    inertia += (r.slowdown - 1) * r.transverse_inertia * (Matrix3d::Identity() - axial) -
               r.axial_inertia * axial;
  }
  return inertia;
}

}  // namespace

RigidBody::RigidBody(const VehicleModel& model, const WorldSettings& world, bool ground)
    : h_(world.step),
      gravity_(world.gravity),
      mass_(model.mass),
      com_B_(model.com_B),
      inertia_(world.quirks.urdf_rotor_inertia ? inertiaOfRotorS(model) : model.inertia_B),
      inverse_inertia_(inertia_.inverse()),
      euler_(world.quirks.euler_integration),
      reaction_(!world.quirks.no_spin_reaction),
      ode_(std::make_unique<OdeWorld>()) {
  OdeWorld& ode = *ode_;
  setMass(ode.body, model.name, mass_, inertia_);
  dBodySetFiniteRotationMode(ode.body, euler_ ? 1 : 0);
  if (!ground || model.boxes.empty()) return;
  ode.makeGround();
  boxes_ = model.boxes;
  for (CollisionBox& box : boxes_) {
    ode.boxes.push_back(dCreateBox(nullptr, box.size.x(), box.size.y(), box.size.z()));
    box.X_BC.translation() -= com_B_;  // from here on relative to C
    reach_ =
        std::max(reach_, box.X_BC.translation().norm() + 0.5 * box.size.norm() + 2 * kContactLayer);
    checkReach(reach_);
  }
}

RigidBody::~RigidBody() = default;

void RigidBody::refreshBodyRates(const Vector3d& momentum_B) {
  momentum_B_ = momentum_B;
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
  // Past ODE's setters: dBodySetQuaternion() normalises anew, which moves the last bit. What the
  // getters point to is the body's own storage.
  archive(const_cast<dReal*>(dBodyGetPosition(ode_->body)), 3);
  archive(const_cast<dReal*>(dBodyGetQuaternion(ode_->body)), 4);
  archive(const_cast<dReal*>(dBodyGetRotation(ode_->body)), 12);
  for (Vector3d* v : {&v_W_, &L_W_, &v_C_B_, &w_B_, &Pi_B_, &momentum_B_, &v_before_W_,
                      &w_before_B_, &ground_load_.force, &ground_load_.torque})
    archive(*v);
}

void RigidBody::motion(StepInput& input) const {
  input.v_WC_B = v_C_B_;
  input.w_WB_B = w_B_;
  input.p_WC = ode_->p();
  input.R_WB = ode_->R();
}

Vector3d RigidBody::specificForce(const Vector3d& r_C) const {
  // a_P = a_C + alpha x r + w x (w x r), with means over the step for the first two and the rate at
  // its end for the third.
  const Vector3d a_W = (v_W_ - v_before_W_) / h_ + Vector3d(0, 0, gravity_);
  const Vector3d alpha = (w_B_ - w_before_B_) / h_;
  return ode_->R().transpose() * a_W + alpha.cross(r_C) + w_B_.cross(w_B_.cross(r_C));
}

bool RigidBody::isFinite() const {
  return ode_->p().allFinite() && v_W_.allFinite() && L_W_.allFinite();
}

namespace {

/// tan(y)/y for y = h|w|/2. ODE's step q + (h/2) w q, normalised, turns by 2 atan(h|w|/2); with w
/// stretched by this factor it turns by h|w|. The series is exact to rounding up to h|w| = 0.04 and
/// to 1e-5 at h|w| = 1.
double rateStretch(double half_angle_squared) {
  const double y2 = half_angle_squared;
  return 1.0 + y2 * (1.0 / 3.0 + y2 * (2.0 / 15.0 + y2 * (17.0 / 315.0 + y2 * (62.0 / 2835.0))));
}

}  // namespace

Vector3d RigidBody::midpointRate(const Vector3d& Pi, const Vector3d& momentum_B, double a) const {
  constexpr int kMaxIterations =
      30;  // the error shrinks by h|w|/2 each time: 5 at 15 rad/s and 1 ms, 1 in hover
  constexpr double kEnough = 1e-26;  // square of the change relative to the rate
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
  // Beyond a radian a step nothing is resolved any more, and ODE ends the process on a turn that is
  // not finite.
  if (h_ * h_ * w.squaredNorm() <= 1.0) return;
  throw quad_support::SimulationError(
      fmt::format("the body turns at {} rad/s, more than a radian in a step",
                  quad_support::shortest(w.norm())));
}

bool RigidBody::step(const StepLoad& load, const std::vector<double>&) {
  if (reaction_) return move(load);
  StepLoad held = load;  // what turns the rotors faster is held by nobody: its reaction is taken
                         // off the body again
  held.torque_B += (load.momentum_end_B - momentum_B_) / h_;
  return move(held);
}

bool RigidBody::move(const StepLoad& load) {
  const Matrix3d R = ode_->R();
  v_before_W_ = v_W_;
  w_before_B_ = w_B_;
  if (reach_ >= 0 && ode_->position[2] < reach_ && collide(R) > 0) {
    stepInContact(R, load);
    return true;
  }
  euler_ ? stepByEuler(R, load) : stepByMidpoint(R, load);
  return false;
}

void RigidBody::stepByMidpoint(const Matrix3d& R, const StepLoad& load) {
  // Half the torque acts before the turn, so that the midpoint is one of the torque as well.
  const double half = 0.5 * h_;
  const double stretch = rateStretch(half * half * w_B_.squaredNorm());
  const Vector3d w =
      midpointRate(Pi_B_ + half * load.torque_B, load.momentum_mean_B, half * stretch);
  checkRate(w);
  // Body-fixed loads as seen from W in the middle of the step: R_mid = R (1 + (h/2) [w]x) to second
  // order.
  const Vector3d turn = half * w;
  Vector3d dv = R * (h_ / mass_ * (load.force_B + turn.cross(load.force_B)));
  dv.z() -= h_ * gravity_;
  const Vector3d v_mid = v_W_ + 0.5 * dv;
  coast(ode_->body, v_mid, R * (stretch * w), h_);
  v_W_ += dv;
  L_W_ += R * (h_ * (load.torque_B + turn.cross(load.torque_B)));
  refreshBodyRates(load.momentum_end_B);
}

/// As Gazebo's ODE does it: velocities by the forces and the gyroscopic torque of the start, poses
/// by the new velocities.
void RigidBody::stepByEuler(const Matrix3d& R, const StepLoad& load) {
  const Vector3d gyroscopic = (inertia_ * w_B_ + load.momentum_mean_B).cross(w_B_);
  const Vector3d spin_up = load.momentum_end_B - momentum_B_;
  const Vector3d w_B = w_B_ + inverse_inertia_ * (h_ * (load.torque_B + gyroscopic) - spin_up);
  checkRate(w_B);
  v_W_ += (h_ / mass_) * (R * load.force_B) - Vector3d(0, 0, h_ * gravity_);
  const Vector3d w_W = R * w_B;
  dBodySetLinearVel(ode_->body, v_W_.x(), v_W_.y(), v_W_.z());
  dBodySetAngularVel(ode_->body, w_W.x(), w_W.y(), w_W.z());
  dWorldStep(ode_->world, h_);
  L_W_ = ode_->R() * (inertia_ * w_B + load.momentum_end_B);
  refreshBodyRates(load.momentum_end_B);
}

/// In contact all of the force acts before the step (semi-implicit Euler, as ODE does it), for the
/// solver must see it.
void RigidBody::stepInContact(const Matrix3d& R, const StepLoad& load) {
  v_W_ += (h_ / mass_) * (R * load.force_B) - Vector3d(0, 0, h_ * gravity_);
  const Vector3d w_B = inverse_inertia_ * (Pi_B_ + h_ * load.torque_B - load.momentum_end_B);
  checkRate(w_B);
  checkContactSpeed(v_W_);
  const Vector3d w_W = R * w_B;
  dBodySetLinearVel(ode_->body, v_W_.x(), v_W_.y(), v_W_.z());
  dBodySetAngularVel(ode_->body, w_W.x(), w_W.y(), w_W.z());
  ode_->quickStep(h_);
  const dReal* v = dBodyGetLinearVel(ode_->body);
  const dReal* w = dBodyGetAngularVel(ode_->body);
  const Matrix3d R_end = ode_->R();
  const Vector3d v_end(v[0], v[1], v[2]), w_end_W(w[0], w[1], w[2]);
  ground_load_ = {mass_ / h_ * (v_end - v_W_),
                  R * (inertia_ * (R.transpose() * (w_end_W - w_W))) / h_};
  v_W_ = v_end;
  const Vector3d w_end_B = R_end.transpose() * w_end_W;
  L_W_ = R_end * (inertia_ * w_end_B + load.momentum_end_B);
  refreshBodyRates(load.momentum_end_B);
}

int RigidBody::collide(const Matrix3d& R_WB) {
  OdeWorld& ode = *ode_;
  int count = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    setPose(ode.boxes[i], ode.p() + R_WB * boxes_[i].X_BC.translation(),
            R_WB * boxes_[i].X_BC.linear());
    count += ode.touch(ode.boxes[i], ode.body);
  }
  return count;
}

}  // namespace quad_sim
