// The Hummingbird with its rotors on hinges: our flight of 4.3 s at 1 ms, with a command and a
// measurement every 100 steps, against the same five bodies on ODE's own hinges with motors, moved
// by QuickStep with 50 iterations and by ODE's direct solver, without anything else. Best of
// several, in turns: other work on the machine only adds time.
#include <ode/ode.h>

#include <cstdio>

#include "flights.hpp"

namespace {

using quad_sim::Multibody;
using namespace quad_sim::bench;

constexpr int kIntervals = 43;

/// The vehicle's bodies on ODE's hinges.
class OdeHinges {
 public:
  OdeHinges(const quad_sim::VehicleModel& model, bool quick) : quick_(quick) {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, -kGravity);
    dWorldSetQuickStepNumIterations(world_, 50);
    double base_mass = model.mass;
    for (const quad_sim::RotorModel& rotor : model.rotors) base_mass -= rotor.mass;
    base_ = makeBody(base_mass, model.inertia_B, Eigen::Vector3d::Zero());
    for (const quad_sim::RotorModel& rotor : model.rotors) {
      const Eigen::Vector3d moments(rotor.transverse_inertia, rotor.transverse_inertia,
                                    rotor.axial_inertia * rotor.slowdown);
      const Eigen::Vector3d& p = rotor.position_B;
      dBodyID body = makeBody(rotor.mass, moments.asDiagonal(), p);
      dJointID hinge = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinge, body, base_);
      dJointSetHingeAnchor(hinge, p.x(), p.y(), kAltitude + p.z());
      dJointSetHingeAxis(hinge, 0, 0, 1);
      dJointSetHingeParam(hinge, dParamFMax, dInfinity);
      dJointSetHingeParam(hinge, dParamVel, rotor.spin * 45.772);
    }
  }
  ~OdeHinges() { dWorldDestroy(world_); }
  OdeHinges(const OdeHinges&) = delete;
  OdeHinges& operator=(const OdeHinges&) = delete;

  void fly() {
    for (int i = 0; i < kIntervals * kStepsPerInterval; ++i) {
      dBodyAddRelForce(base_, 0, 0, 7.164);
      quick_ ? dWorldQuickStep(world_, kStep) : dWorldStep(world_, kStep);
    }
  }

 private:
  dBodyID makeBody(double mass, const Eigen::Matrix3d& inertia, const Eigen::Vector3d& p) {
    dBodyID body = dBodyCreate(world_);
    dMass m;
    dMassSetParameters(&m, mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2), 0, 0, 0);
    dBodySetMass(body, &m);
    dBodySetPosition(body, p.x(), p.y(), kAltitude + p.z());
    return body;
  }

  bool quick_;
  dWorldID world_;
  dBodyID base_;
};

}  // namespace

int main() {
  const quad_sim::VehicleModel model = quad_sim::bench::hummingbird();
  OdeHinges quick(model, true), direct(model, false);
  Flight hinged(Multibody::kHinged, kIntervals), folded(Multibody::kFolded, kIntervals);
  constexpr int kRepetitions = 15;
  const auto [quick_s, hinged_s, direct_s, folded_s] = quad_sim::bench::bestInTurns<4>(
      {[&] { quick.fly(); }, [&] { hinged.fly(); }, [&] { direct.fly(); }, [&] { folded.fly(); }},
      kRepetitions);
  constexpr double kMicroseconds = 1e6 / (kIntervals * kStepsPerInterval);
  std::printf(
      "a step: hinged %.2f us, folded %.2f us, ODE's hinges by its direct solver %.2f us, by "
      "QuickStep(50) %.2f us\n",
      kMicroseconds * hinged_s, kMicroseconds * folded_s, kMicroseconds * direct_s,
      kMicroseconds * quick_s);
  std::printf("ratio QuickStep(50)/hinged = %.2f (limit 3, goal 4), best of %d\n",
              quick_s / hinged_s, kRepetitions);
}
