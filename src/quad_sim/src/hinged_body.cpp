#include "hinged_body.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ode_world.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double kErp =
    0.2;  // RotorS's world: a fifth of what a hinge is off is led back in a step
constexpr double kNoErp = 0.0;

/// Inertia of a point mass about the origin, Steiner's term.
Matrix3d steiner(double mass, const Vector3d& r) {
  return mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

Vector3d linearVelocity(dBodyID body) {
  const dReal* v = dBodyGetLinearVel(body);
  return Vector3d(v[0], v[1], v[2]);
}
Vector3d angularVelocity(dBodyID body) {
  const dReal* w = dBodyGetAngularVel(body);
  return Vector3d(w[0], w[1], w[2]);
}
void setVelocity(dBodyID body, const Vector3d& v, const Vector3d& w) {
  dBodySetLinearVel(body, v.x(), v.y(), v.z());
  dBodySetAngularVel(body, w.x(), w.y(), w.z());
}

Eigen::Quaterniond orientationOf(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}
void place(dBodyID body, const Vector3d& p, const Eigen::Quaterniond& q) {
  const dQuaternion q_ode = {q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(body, p.x(), p.y(), p.z());
  dBodySetQuaternion(body, q_ode);
}

}  // namespace

struct HingedBody::Rotor {
  dBodyID body;
  dJointID hinge;
  dGeomID disc;  ///< nullptr: it touches nothing
  double mass;
  double axial, transverse;  ///< inertia [kg m²] as the hinge feels it
  double spin_per_speed;     ///< hinge speed over rotor speed: the spin's sign, slowed down or not
  Vector3d hub_B;            ///< from the base's centre of mass
  Vector3d axis_B;
  Eigen::Quaterniond rest_B;  ///< body to base at angle 0: the body's z is the axis
  Vector3d axis_W() const { return orientationOf(body) * Vector3d::UnitZ(); }
};

HingedBody::HingedBody(const VehicleModel& model, const WorldSettings& world, bool ground)
    : h_(world.step),
      gravity_(world.gravity),
      mass_(model.mass),
      com_B_(model.com_B),
      reaction_(!world.quirks.no_spin_reaction),
      euler_(world.quirks.euler_integration || world.quirks.no_spin_reaction),
      ode_(std::make_unique<OdeWorld>()) {
  // The base is what the rotors leave of the vehicle.
  base_mass_ = model.mass;
  Vector3d moment = model.mass * model.com_B;
  base_inertia_ = model.inertia_B + steiner(model.mass, model.com_B);
  for (const RotorModel& r : model.rotors) {
    base_mass_ -= r.mass;
    moment -= r.mass * r.position_B;
    base_inertia_ -= r.transverse_inertia * Matrix3d::Identity() +
                     (r.axial_inertia - r.transverse_inertia) * r.axis_B * r.axis_B.transpose() +
                     steiner(r.mass, r.position_B);
  }
  base_com_B_ = moment / base_mass_;
  base_inertia_ -= steiner(base_mass_, base_com_B_);
  if (!(base_mass_ > 0) || base_inertia_.llt().info() != Eigen::Success) {
    throw std::invalid_argument(fmt::format(
        "simulation.multibody = hinged; {}: what is left without the rotors, {} kg, is no body "
        "with a positive mass and inertia; use folded",
        model.name, quad_support::shortest(base_mass_)));
  }
  setMass(ode_->body, model.base_link, base_mass_, base_inertia_);
  dBodySetFiniteRotationMode(ode_->body, 1);
  checkHubs(model);
  makeRotors(model, world);
  if (ground) makeGround(model);
}

void HingedBody::checkHubs(const VehicleModel& model) {
  for (const RotorModel& r : model.rotors) checkReach((r.position_B - base_com_B_).norm());
}

void HingedBody::makeRotors(const VehicleModel& model, const WorldSettings& world) {
  for (const RotorModel& r : model.rotors) {
    const double slow = world.quirks.urdf_rotor_inertia ? r.slowdown : 1.0;
    Rotor rotor{};
    rotor.mass = r.mass;
    rotor.axial = slow * r.axial_inertia;
    rotor.transverse = slow * r.transverse_inertia;
    rotor.spin_per_speed = r.spin / slow;
    rotor.hub_B = r.position_B - base_com_B_;
    rotor.axis_B = r.axis_B;
    rotor.rest_B = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), r.axis_B);
    rotor.body = dBodyCreate(ode_->world);
    setMass(rotor.body, r.link, rotor.mass,
            Vector3d(rotor.transverse, rotor.transverse, rotor.axial).asDiagonal());
    dBodySetGyroscopicMode(rotor.body, 0);
    dBodySetFiniteRotationMode(rotor.body, 1);
    place(rotor.body, rotor.hub_B, rotor.rest_B);
    rotor.hinge = dJointCreateHinge(ode_->world, nullptr);
    dJointAttach(rotor.hinge, rotor.body, ode_->body);
    dJointSetHingeAnchor(rotor.hinge, rotor.hub_B.x(), rotor.hub_B.y(), rotor.hub_B.z());
    dJointSetHingeAxis(rotor.hinge, rotor.axis_B.x(), rotor.axis_B.y(), rotor.axis_B.z());
    dJointSetHingeParam(rotor.hinge, dParamFMax, dInfinity);
    rotors_.push_back(rotor);
  }
  enableHinges(false);
}

void HingedBody::makeGround(const VehicleModel& model) {
  ode_->makeGround();
  constexpr int kIterations =
      200;  // hinges and contacts together; 50, enough for contacts alone, leave the hinges soft
  dWorldSetQuickStepNumIterations(ode_->world, kIterations);
  boxes_ = model.boxes;
  for (CollisionBox& box : boxes_) {
    ode_->boxes.push_back(dCreateBox(nullptr, box.size.x(), box.size.y(), box.size.z()));
    box.X_BC.translation() -= base_com_B_;
    reach_ =
        std::max(reach_, box.X_BC.translation().norm() + 0.5 * box.size.norm() + 2 * kContactLayer);
    checkReach(reach_);
  }
  for (std::size_t i = 0; i < rotors_.size(); ++i) {
    const RotorModel& r = model.rotors[i];
    if (!(r.disc_radius > 0) || !(r.disc_height > 0)) continue;
    checkReach(rotors_[i].hub_B.norm() + r.disc_radius + r.disc_height);
    rotors_[i].disc = dCreateCylinder(nullptr, r.disc_radius, r.disc_height);
    ode_->boxes.push_back(rotors_[i].disc);  // destroyed with the boxes
    reach_ = std::max(reach_,
                      rotors_[i].hub_B.norm() + r.disc_radius + r.disc_height + 2 * kContactLayer);
  }
}

HingedBody::~HingedBody() = default;

void HingedBody::enableHinges(bool on) {
  for (const Rotor& r : rotors_) on ? dJointEnable(r.hinge) : dJointDisable(r.hinge);
}

HingedBody::Twist HingedBody::twist() const {
  return {linearVelocity(ode_->body), angularVelocity(ode_->body)};
}

void HingedBody::restore(const VehicleState& state, const Vector3d&) {
  const Eigen::Quaterniond q = state.q_WB.normalized();
  place(ode_->body, state.p_WB + q * base_com_B_, q);
  for (const Rotor& r : rotors_)
    place(r.body, state.p_WB + q * (base_com_B_ + r.hub_B), q * r.rest_B);
  const Vector3d w_W = q * state.w_WB_B;
  setVelocities({state.v_WB + w_W.cross(q * base_com_B_), w_W}, ode_->R(), state.rotor_speed);
  before_ = twist();
}

void HingedBody::save(VehicleState& state) const {
  const Matrix3d R = ode_->R();
  const Twist now = twist();
  state.q_WB = orientationOf(ode_->body);
  state.p_WB = ode_->p() - R * base_com_B_;
  state.w_WB_B = R.transpose() * now.w_W;
  state.v_WB = now.v_W - now.w_W.cross(R * base_com_B_);
}

void HingedBody::archive(StateArchive& archive) {
  std::vector<dBodyID> bodies = {ode_->body};
  for (const Rotor& r : rotors_) bodies.push_back(r.body);
  for (dBodyID body : bodies) {  // past ODE's setters, which normalise anew
    archive(const_cast<dReal*>(dBodyGetPosition(body)), 3);
    archive(const_cast<dReal*>(dBodyGetQuaternion(body)), 4);
    archive(const_cast<dReal*>(dBodyGetRotation(body)), 12);
    archive(const_cast<dReal*>(dBodyGetLinearVel(body)), 3);
    archive(const_cast<dReal*>(dBodyGetAngularVel(body)), 3);
  }
  archive(before_.v_W);
  archive(before_.w_W);
}

void HingedBody::motion(StepInput& input) const {
  const Twist now = twist();
  input.R_WB = ode_->R();
  const Vector3d r_W = input.R_WB * (com_B_ - base_com_B_);
  input.p_WC = ode_->p() + r_W;
  input.v_WC_B = input.R_WB.transpose() * (now.v_W + now.w_W.cross(r_W));
  input.w_WB_B = input.R_WB.transpose() * now.w_W;
}

Vector3d HingedBody::specificForce(const Vector3d& r_C) const {
  const Twist now = twist();
  const Matrix3d R = ode_->R();
  const Vector3d r_W = R * (r_C + com_B_ - base_com_B_);
  const Vector3d a_W = (now.v_W - before_.v_W) / h_ + Vector3d(0, 0, gravity_);
  const Vector3d alpha_W = (now.w_W - before_.w_W) / h_;
  return R.transpose() * (a_W + alpha_W.cross(r_W) + now.w_W.cross(now.w_W.cross(r_W)));
}

bool HingedBody::isFinite() const {
  return ode_->p().allFinite() && linearVelocity(ode_->body).allFinite() &&
         angularVelocity(ode_->body).allFinite();
}

std::vector<RotorState> HingedBody::rotors() const {
  std::vector<RotorState> all;
  for (const Rotor& r : rotors_) {
    all.push_back({positionOf(r.body), orientationOf(r.body), linearVelocity(r.body),
                   angularVelocity(r.body)});
  }
  return all;
}

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
  sum.angular -= (R * (com_B_ - base_com_B_)).cross(sum.linear);
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
  ode_->quickStep(h_);
  enableHinges(false);
}

}  // namespace quad_sim
