#include "hinged_body.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hinged_rotor.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {

using Eigen::Matrix3d;
using Eigen::Vector3d;

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
  archive(ground_load_.force);
  archive(ground_load_.torque);
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

}  // namespace quad_sim
