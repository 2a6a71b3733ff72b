// How a hinged vehicle moves: momenta, hinges, one step.
#include <fmt/core.h>

#include <Eigen/LU>
#include <cmath>

#include "hinged_rotor.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double kErp =
    0.2;  // RotorS's world: a fifth of what a hinge is off is led back in a step
constexpr double kNoErp = 0.0;

}  // namespace

Matrix3d HingedBody::inertiaOf(const Rotor& r, const Vector3d& axis_W) const {
  const double along = reaction_ ? r.axial : 0.0;  // a free hinge passes no torque about its axis
  return r.transverse * Matrix3d::Identity() + (along - r.transverse) * axis_W * axis_W.transpose();
}

/// A round rotor's momentum keeps its direction in the turning base, whatever its spin: the torque
/// is -w_base x L.
Vector3d HingedBody::gyroscopicTorque(const Rotor& r, const Vector3d& w_W) const {
  const Vector3d axis = r.axis_W(), w = angularVelocity(r.body);
  const Vector3d L = r.transverse * w + (r.axial - r.transverse) * axis.dot(w) * axis;
  return L.cross(w_W);
}

HingedBody::Momentum HingedBody::momentum(const Matrix3d& R) const {
  const Twist now = twist();
  Momentum sum{base_mass_ * now.v_W, R * (base_inertia_ * (R.transpose() * now.w_W))};
  for (const Rotor& r : rotors_) {
    const Vector3d p = r.mass * linearVelocity(r.body);
    sum.linear += p;
    // At its hinge, not where it has drifted: there solveHinges() looks for it too.
    sum.angular += (R * r.hub_B).cross(p) + inertiaOf(r, r.axis_W()) * angularVelocity(r.body);
  }
  return sum;
}

HingedBody::Momentum HingedBody::aboutCentre(Momentum sum, const Matrix3d& R) const {
  sum.angular -= (R * (com_B_ - base_com_B_)).cross(sum.linear);
  return sum;
}

void HingedBody::addImpulse(const StepLoad& load, const Matrix3d& R, Momentum& sum) const {
  const Vector3d impulse = h_ * (R * load.force_B - Vector3d(0, 0, mass_ * gravity_));
  sum.linear += impulse;
  sum.angular += h_ * (R * load.torque_B) + (R * (com_B_ - base_com_B_)).cross(impulse);
}

void HingedBody::addGyroscopicTorques(Momentum& sum, const Matrix3d& R) const {
  const Vector3d w = twist().w_W, w_B = R.transpose() * w;
  sum.angular += h_ * (R * (base_inertia_ * w_B).cross(w_B));
  for (const Rotor& r : rotors_) sum.angular += h_ * gyroscopicTorque(r, w);
  // The rotors' hubs, held at the base, go round with it: their centripetal force, too, is a torque
  // about its centre of mass.
  for (const Rotor& r : rotors_) {
    const Vector3d arm = R * r.hub_B;
    const Vector3d impulse = h_ * r.mass * w.cross(w.cross(arm));
    sum.linear -= impulse;
    sum.angular -= arm.cross(impulse);
  }
}

Vector3d HingedBody::gap(const Rotor& r, const Matrix3d& R) const {
  return ode_->p() + R * r.hub_B - positionOf(r.body);
}

Vector3d HingedBody::tilt(const Rotor& r, const Matrix3d& R) const {
  return r.axis_W().cross(R * r.axis_B);
}

HingedBody::Twist HingedBody::solveHinges(Momentum momentum, const Matrix3d& R,
                                          const std::vector<double>& rotor_speed,
                                          double erp) const {
  Matrix3d inertia = R * base_inertia_ * R.transpose();
  Vector3d first_moment = Vector3d::Zero();
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor& r = rotors_[i];
    const Vector3d arm = R * r.hub_B, axis = r.axis_W(), back = erp / h_ * gap(r, R);
    const Matrix3d J = inertiaOf(r, axis);
    inertia += J + steiner(r.mass, arm);
    first_moment += r.mass * arm;
    momentum.linear -= r.mass * back;
    momentum.angular -= r.mass * arm.cross(back) +
                        J * (r.spin_per_speed * rotor_speed[i] * axis + erp / h_ * tilt(r, R));
  }
  // m v + w x (sum m r) = linear and (sum m r) x v + inertia w = angular; v eliminated.
  const Vector3d v_all = momentum.linear / mass_, centre = first_moment / mass_;
  const Matrix3d about_centre = inertia - steiner(mass_, centre);
  const Vector3d w = about_centre.inverse() * (momentum.angular - first_moment.cross(v_all));
  return {v_all - w.cross(centre), w};
}

void HingedBody::setVelocities(const Twist& twist, const Matrix3d& R,
                               const std::vector<double>& rotor_speed) {
  setVelocity(ode_->body, twist.v_W, twist.w_W);
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor& r = rotors_[i];
    setVelocity(r.body, twist.v_W + twist.w_W.cross(R * r.hub_B),
                twist.w_W + r.spin_per_speed * rotor_speed[i] * r.axis_W());
  }
}

void HingedBody::move(const Twist& twist, const Matrix3d& R,
                      const std::vector<double>& rotor_speed) {
  setVelocity(ode_->body, twist.v_W, twist.w_W);
  for (const Rotor& r : rotors_) {
    // The hub goes round an arc: its chord is seen from the middle of the turn.
    const Vector3d arm = R * r.hub_B, middle = arm + 0.5 * h_ * twist.w_W.cross(arm);
    setVelocity(r.body, twist.v_W + twist.w_W.cross(middle) + kErp / h_ * gap(r, R),
                twist.w_W + kErp / h_ * tilt(r, R));
  }
  dWorldStep(ode_->world, h_);
  // The fast turn about the axis comes after the slow one of the axis: one rotation by both
  // together would carry the axis round.
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const Rotor& r = rotors_[i];
    const double half = 0.5 * h_ * r.spin_per_speed * rotor_speed[i];
    const Eigen::Quaterniond q =
        orientationOf(r.body) * Eigen::Quaterniond(std::cos(half), 0, 0, std::sin(half));
    const dQuaternion q_ode = {q.w(), q.x(), q.y(), q.z()};
    dBodySetQuaternion(r.body, q_ode);
  }
}

void HingedBody::checkRate(const Vector3d& w) const {
  if (h_ * w.norm() <= 1.0) return;  // see RigidBody::checkRate()
  throw quad_support::SimulationError(
      fmt::format("the body turns at {} rad/s, more than a radian in a step",
                  quad_support::shortest(w.norm())));
}

bool HingedBody::step(const StepLoad& load, const std::vector<double>& rotor_speed) {
  const Matrix3d R = ode_->R();
  before_ = twist();
  if (reach_ >= 0 && ode_->p().z() < reach_ && collide(R) > 0) {
    stepInContact(load, R, rotor_speed);
    return true;
  }
  euler_ ? stepByEuler(load, R, rotor_speed) : stepByMidpoint(load, R, rotor_speed);
  return false;
}

void HingedBody::stepByMidpoint(const StepLoad& load, const Matrix3d& R,
                                const std::vector<double>& rotor_speed) {
  Momentum sum = momentum(R), guess = sum;
  addImpulse(load, R, guess);
  addGyroscopicTorques(guess, R);
  const Twist next = solveHinges(guess, R, rotor_speed, kNoErp);
  checkRate(next.w_W);
  const Twist mean{0.5 * (before_.v_W + next.v_W), 0.5 * (before_.w_W + next.w_W)};
  // Body-fixed loads as seen from W in the middle of the step, and the momentum about the vehicle's
  // centre of mass, which only they change.
  const Vector3d half_turn = 0.5 * h_ * mean.w_W;
  const Matrix3d R_mid = R + (Matrix3d() << half_turn.cross(R.col(0)), half_turn.cross(R.col(1)),
                              half_turn.cross(R.col(2)))
                                 .finished();
  sum = aboutCentre(sum, R);
  sum.linear += h_ * (R_mid * load.force_B - Vector3d(0, 0, mass_ * gravity_));
  sum.angular += h_ * (R_mid * load.torque_B);
  move(mean, R, rotor_speed);
  const Matrix3d R_end = ode_->R();
  sum.angular += (R_end * (com_B_ - base_com_B_)).cross(sum.linear);
  setVelocities(solveHinges(sum, R_end, rotor_speed, kNoErp), R_end, rotor_speed);
}

/// As Gazebo's ODE does it: velocities by the forces and gyroscopic torques of the start, poses by
/// the new velocities.
void HingedBody::stepByEuler(const StepLoad& load, const Matrix3d& R,
                             const std::vector<double>& rotor_speed) {
  Momentum sum = momentum(R);
  addImpulse(load, R, sum);
  addGyroscopicTorques(sum, R);
  const Twist next = solveHinges(sum, R, rotor_speed, kErp);
  checkRate(next.w_W);
  move(next, R, rotor_speed);
  setVelocities(next, ode_->R(), rotor_speed);
}

int HingedBody::collide(const Matrix3d& R) {
  int count = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    setPose(ode_->boxes[i], ode_->p() + R * boxes_[i].X_BC.translation(),
            R * boxes_[i].X_BC.linear());
    count += ode_->touch(ode_->boxes[i], ode_->body);
  }
  for (const Rotor& r : rotors_) {
    if (!r.disc) continue;
    setPose(r.disc, positionOf(r.body), rotationOf(r.body));
    count += ode_->touch(r.disc, r.body);
  }
  return count;
}

void HingedBody::stepInContact(const StepLoad& load, const Matrix3d& R,
                               const std::vector<double>& rotor_speed) {
  // The forces act before the solver, as if in the air; then contacts and hinges together.
  Momentum sum = momentum(R);
  addImpulse(load, R, sum);
  const Twist pushed = solveHinges(sum, R, rotor_speed, kNoErp);
  checkRate(pushed.w_W);
  checkContactSpeed(pushed.v_W);
  setVelocities(pushed, R, rotor_speed);
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    dJointSetHingeParam(rotors_[i].hinge, dParamVel, rotors_[i].spin_per_speed * rotor_speed[i]);
  }
  enableHinges(true);
  const Momentum in_the_air = aboutCentre(momentum(R), R);
  ode_->quickStep(h_);
  enableHinges(false);
  const Momentum on_the_ground = aboutCentre(momentum(R), R);
  ground_load_ = {(on_the_ground.linear - in_the_air.linear) / h_,
                  (on_the_ground.angular - in_the_air.angular) / h_};
}

}  // namespace quad_sim
