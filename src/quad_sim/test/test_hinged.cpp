// Rotors as bodies of their own: against ODE's own hinges, on their hinges, tilted, on the ground,
// and what tumbling does to them.
#include <gmock/gmock.h>
#include <ode/ode.h>

#include <cmath>

#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

SimulatorOptions hinged(double step = 0.001, bool ground = false) {
  SimulatorOptions options;
  options.step = step;
  options.ground = ground;
  options.multibody = Multibody::kHinged;
  return options;
}

/// Base and rotors, standing still on it, joined by ODE's own hinges with motors and moved by ODE
/// alone: its direct solver, its gyroscopic torque. Built from the Hummingbird's figures, not from
/// the model.
class OdeHummingbird {
 public:
  explicit OdeHummingbird(const VehicleState& start) {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, -9.8);
    dWorldSetERP(world_, 0.2);
    dWorldSetCFM(world_, 0);
    const Matrix3d R = start.q_WB.toRotationMatrix();
    const auto body = [&](double mass, const Vector3d& inertia, const Vector3d& p_B) {
      dBodyID b = dBodyCreate(world_);
      dMass m;
      dMassSetParameters(&m, mass, 0, 0, 0, inertia.x(), inertia.y(), inertia.z(), 0, 0, 0);
      dBodySetMass(b, &m);
      const Vector3d p = start.p_WB + R * p_B, v = start.v_WB + R * start.w_WB_B.cross(p_B),
                     w = R * start.w_WB_B;
      const dQuaternion q = {start.q_WB.w(), start.q_WB.x(), start.q_WB.y(), start.q_WB.z()};
      dBodySetPosition(b, p.x(), p.y(), p.z());
      dBodySetQuaternion(b, q);
      dBodySetLinearVel(b, v.x(), v.y(), v.z());
      dBodySetAngularVel(b, w.x(), w.y(), w.z());
      dBodySetFiniteRotationMode(b, 1);
      return b;
    };
    // 0.68 + IMU 0.015 + three markers; each of the four sensors adds 1e-5 kg m² to the base.
    base_ = body(0.69503, Vector3d(0.00704, 0.00704, 0.01204), Vector3d::Zero());
    const double f = 0.0833333 * 0.009, axial = f * (0.01 + 0.000225),
                 transverse = 0.5 * f * (0.01 + 0.000225 + 2 * 9e-6);
    const double x[] = {0.17, 0, -0.17, 0}, y[] = {0, 0.17, 0, -0.17};
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3d hub(x[i], y[i], 0.01), at = start.p_WB + R * hub, e = R.col(2);
      dBodyID rotor = body(0.009, Vector3d(transverse, transverse, axial), hub);
      dJointID joint = dJointCreateHinge(world_, nullptr);
      dJointAttach(joint, rotor, base_);
      dJointSetHingeAnchor(joint, at.x(), at.y(), at.z());
      dJointSetHingeAxis(joint, e.x(), e.y(), e.z());
      dJointSetHingeParam(joint, dParamFMax, dInfinity);
    }
  }
  ~OdeHummingbird() { dWorldDestroy(world_); }
  OdeHummingbird(const OdeHummingbird&) = delete;
  OdeHummingbird& operator=(const OdeHummingbird&) = delete;

  void step(double h) { dWorldStep(world_, h); }
  Vector3d position() const { return Vector3d(dBodyGetPosition(base_)); }
  Quaterniond orientation() const {
    const dReal* q = dBodyGetQuaternion(base_);
    return Quaterniond(q[0], q[1], q[2], q[3]);
  }

 private:
  dWorldID world_;
  dBodyID base_;
};

TEST(Hinged, FollowsOdesOwnHinges) {
  // Thrown and tumbling, rotors still: ODE's solver is a first-order method, so what it differs
  // from ours by shrinks with the step.
  const VehicleModel m = hummingbird();
  VehicleState start;
  start.p_WB.z() = 10;
  start.v_WB = Vector3d(1, 0, 3);
  start.w_WB_B = Vector3d(3, 2, 4);
  start.rotor_speed.assign(4, 0.0);
  const auto difference = [&](double h) {
    Simulator ours(m, hinged(h));
    ours.setStartState(start);
    OdeHummingbird theirs(start);
    const int steps = static_cast<int>(std::lround(0.5 / h));
    for (int i = 0; i < steps; ++i) theirs.step(h);
    ours.advance(steps);
    const VehicleState end = ours.state();
    return std::make_pair((end.p_WB - theirs.position()).norm(),
                          end.q_WB.angularDistance(theirs.orientation()));
  };
  const auto coarse = difference(1e-3), fine = difference(2.5e-4);
  std::printf("ours - ODE's hinges: %.2e m, %.2e rad at 1 ms; %.2e m, %.2e rad at 0.25 ms\n",
              coarse.first, coarse.second, fine.first, fine.second);
  // Semi-implicit Euler falls h g t / 2 = 2.45e-3 m too far in half a second; the rest of the
  // distance is second order.
  EXPECT_NEAR(coarse.first, 2.45e-3, 1e-4);
  EXPECT_LT(fine.first, coarse.first / 3.5);
  // And turns by w (h w) t too far or short, at most: 5.4² * 1e-3 * 0.5.
  EXPECT_LT(coarse.second, 0.015);
  EXPECT_LT(fine.second, coarse.second / 3);
}

TEST(Hinged, RotorsStayOnTheirHinges) {
  const VehicleModel m = hummingbird();
  Simulator s(m, hinged());
  VehicleState start = equilibrium(m, 9.8, 100);
  start.w_WB_B = Vector3d(6, 8, -4);
  s.setStartState(start);
  s.setCommand({500, 440, 470, 458});
  double worst = 0, worst_tilt = 0;
  for (int i = 0; i < 100; ++i) {
    s.advance(10);
    const VehicleState now = s.state();
    const std::vector<RotorState> rotors = s.rotorStates();
    ASSERT_EQ(rotors.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      worst =
          std::max(worst, (rotors[k].p_WR - now.p_WB - now.q_WB * m.rotors[k].position_B).norm());
      worst_tilt = std::max(
          worst_tilt,
          (rotors[k].q_WR * Vector3d::UnitZ()).cross(now.q_WB * m.rotors[k].axis_B).norm());
      // Its spin is the motor's, in its direction.
      const double spin =
          (rotors[k].w_WR - now.q_WB * now.w_WB_B).dot(rotors[k].q_WR * Vector3d::UnitZ());
      EXPECT_NEAR(spin, m.rotors[k].spin * now.rotor_speed[k], 1e-2 * now.rotor_speed[k]);
    }
  }
  // A step off the tangent leaves (h w)² l / 2 = 1e-5 m at 11 rad/s, of which erp takes a fifth
  // back each time: five times that at most.
  EXPECT_LT(worst, 5 * 0.5 * std::pow(0.001 * 15, 2) * 0.17);
  EXPECT_LT(worst_tilt, 5 * std::pow(0.001 * 15, 2) + 0.005);
  EXPECT_TRUE(Simulator(m, SimulatorOptions{}).rotorStates().empty());
}

TEST(Hinged, TumblingConservesMomentumAndNearlyEnergy) {
  // Angular momentum to rounding; energy to second order in the step, which is written down here
  // and in the docs.
  const VehicleModel m = hummingbird();
  const auto drift = [&](double h) {
    SimulatorOptions options = hinged(h);
    options.gravity = 0;
    Simulator s(m, options);
    VehicleState start;
    start.w_WB_B = Vector3d(1, 5, 3);
    start.rotor_speed.assign(4, 0.0);
    s.setStartState(start);
    const auto momentum = [&](const VehicleState& x) {
      return (x.q_WB * (m.inertia_B * x.w_WB_B)).eval();
    };
    const auto energy = [&](const VehicleState& x) {
      return 0.5 * x.w_WB_B.dot(m.inertia_B * x.w_WB_B);
    };
    const Vector3d L0 = momentum(start);
    double worst_L = 0, worst_E = 0;
    for (int i = 0; i < 100; ++i) {
      s.advance(static_cast<int>(std::lround(0.1 / h)));
      worst_L = std::max(worst_L, (momentum(s.state()) - L0).norm() / L0.norm());
      worst_E = std::max(worst_E, std::abs(energy(s.state()) / energy(start) - 1));
    }
    return std::make_pair(worst_L, worst_E);
  };
  const auto coarse = drift(1e-3), fine = drift(5e-4);
  std::printf(
      "hinged tumble, 5.9 rad/s, 10 s: momentum off by %.1e, energy by %.1e at 1 ms; %.1e, %.1e at "
      "0.5 ms\n",
      coarse.first, coarse.second, fine.first, fine.second);
  EXPECT_LT(coarse.first, 1e-6);
  EXPECT_LT(coarse.second, 1e-4);
  EXPECT_LT(fine.second, 0.3 * coarse.second);
}

TEST(Hinged, TiltedRotorsHoverAlike) {
  // Each rotor tilted by 20 degrees about its arm: both ways of modelling feel the same forces.
  VehicleModel m = hummingbird();
  for (RotorModel& r : m.rotors) {
    const Vector3d arm = Vector3d(r.position_B.x(), r.position_B.y(), 0).normalized();
    r.axis_B = Eigen::AngleAxisd(r.spin * 0.35, arm) * Vector3d::UnitZ();
  }
  VehicleState start = equilibrium(m, 9.8, 10);
  start.w_WB_B = Vector3d(0.1, 0.2, 0.1);
  SimulatorOptions folded;
  folded.ground = false;
  const auto fly = [&](SimulatorOptions options, double h) {
    options.step = h;
    Simulator s(m, options);
    s.setStartState(start);
    s.setCommand({470, 450, 460, 465});
    s.advance(static_cast<int>(std::lround(1 / h)));
    return s.state();
  };
  const VehicleState truth = fly(folded, 1e-4);
  const auto off = [&](const VehicleState& x) {
    return (x.p_WB - truth.p_WB).norm() + x.q_WB.angularDistance(truth.q_WB);
  };
  const double coarse = off(fly(hinged(), 2e-3)), fine = off(fly(hinged(), 1e-3));
  EXPECT_GE(coarse / fine, 1.8);  // the truth is itself off by a hundredth of it
  EXPECT_LT(fine, 0.02);
}

TEST(Hinged, RestsOnTheGroundAndLandsThere) {
  const VehicleModel m = hummingbird();
  Simulator s(m, hinged(0.001, true));
  s.advance(1000);
  EXPECT_NEAR(s.state().p_WB.z(), 0.06,
              2e-5);  // within the contact layer and what QuickStep leaves
  EXPECT_LT(s.state().v_WB.norm(), 1e-4);
  VehicleState start;
  start.p_WB.z() = 0.5;
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.advance(3000);
  EXPECT_TRUE(s.groundContact());
  EXPECT_NEAR(s.state().p_WB.z(), 0.06, 2e-5);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(
        (s.rotorStates()[i].p_WR - s.state().p_WB - s.state().q_WB * m.rotors[i].position_B).norm(),
        1e-3)
        << i;
  }
}

TEST(Hinged, ResetAndSavedStateGiveTheSameBits) {
  const VehicleModel m = hummingbird();
  Simulator s(m, hinged());
  s.setStartState(equilibrium(m, 9.8, 10));
  s.setCommand({470, 450, 460, 465});
  s.advance(200);
  const SavedState half = s.save();
  s.advance(200);
  const VehicleState first = s.state();
  const auto same = [&](const VehicleState& x) {
    return x.p_WB == first.p_WB && x.q_WB.coeffs() == first.q_WB.coeffs() && x.v_WB == first.v_WB &&
           x.w_WB_B == first.w_WB_B;
  };
  s.reset();
  s.setCommand({470, 450, 460, 465});
  s.advance(400);
  EXPECT_TRUE(same(s.state()));
  Simulator other(m, hinged());
  other.restore(half);
  other.advance(200);
  EXPECT_TRUE(same(other.state()));
}

TEST(Hinged, AVehicleThatIsAllRotorsIsRefused) {
  VehicleModel m = hummingbird();
  m.rotors[0].mass = 2 * m.mass;
  EXPECT_THAT(complaint<std::invalid_argument>([&] { Simulator(m, hinged()); }),
              testing::HasSubstr("multibody = hinged"));
}

}  // namespace
}  // namespace quad_sim
