// The rotor plugin against formulas: exact lag, impulse independent of the step, forces by hand.
#include <cmath>
#include <limits>

#include "../src/rotor_plugin.hpp"
#include "hummingbird.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
constexpr double kEps = std::numeric_limits<double>::epsilon();

struct Outcome {
  StepLoad load{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  std::vector<double> speed;
};

/// `steps` steps of `step` [s] from `start` towards `command`, the loads averaged over them.
Outcome fly(const VehicleModel& m, double step, int steps, const std::vector<double>& start,
            const std::vector<double>& command, const Vector3d& v = Vector3d::Zero(),
            const Vector3d& w = Vector3d::Zero()) {
  RotorPlugin rotors(m, step);
  VehicleState state;
  state.rotor_speed = start;
  rotors.restore(state);
  Outcome out;
  for (int i = 0; i < steps; ++i) rotors.step({v, w, command.data()}, out.load);
  out.load.force_B /= steps;
  out.load.torque_B /= steps;
  rotors.save(state);
  out.speed = state.rotor_speed;
  return out;
}

TEST(Rotor, LagIsTheExponential) {
  const VehicleModel m = hummingbird();
  const Outcome out = fly(m, 0.001, 10, {100, 100, 500, 0}, {400, 100, 200, 300});
  const double up = std::exp(-0.01 / 0.0125), down = std::exp(-0.01 / 0.025);
  // Ten products and sums of numbers up to 500.
  const double tolerance = 20 * 500 * kEps;
  EXPECT_NEAR(out.speed[0], 400 - 300 * up, tolerance);
  EXPECT_EQ(out.speed[1], 100);
  EXPECT_NEAR(out.speed[2], 200 + 300 * down, tolerance);
  EXPECT_NEAR(out.speed[3], 300 - 300 * up, tolerance);
}

TEST(Rotor, SpeedAndImpulseDoNotDependOnTheStep) {
  const VehicleModel m = hummingbird();
  const std::vector<double> start = {100, 600, 838, 0}, command = {500, 200, 0, 838};
  const Vector3d v(1, -2, 3), w(0.5, -0.3, 1);
  const Outcome coarse = fly(m, 0.1, 1, start, command, v, w);
  for (int steps : {2, 10, 100, 1000}) {
    SCOPED_TRACE(steps);
    const Outcome fine = fly(m, 0.1 / steps, steps, start, command, v, w);
    // Rounding grows with the number of products; forces are of the order of 10.
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(fine.speed[i], coarse.speed[i], 5 * steps * 838 * kEps);
    EXPECT_LT((fine.load.force_B - coarse.load.force_B).norm(), 10 * steps * 10 * kEps);
    EXPECT_LT((fine.load.torque_B - coarse.load.torque_B).norm(), 10 * steps * 10 * kEps);
  }
}

TEST(Rotor, HoverForcesByHand) {
  const VehicleModel m = hummingbird();
  const double w = 457.72, kf = 8.54858e-06;
  const Outcome out = fly(m, 0.001, 1, {w, w, w, w}, {w, w, w, w});
  EXPECT_NEAR(out.load.force_B.z(), 4 * kf * w * w, 1e-14);
  EXPECT_NEAR(out.load.force_B.head<2>().norm(), 0, 0);
  EXPECT_NEAR(out.load.torque_B.norm(), 0, 1e-16);  // balanced spins and arms
  EXPECT_NEAR(out.load.momentum_end_B.norm(), 0, 1e-18);
}

TEST(Rotor, TorquesByHand) {
  // thesis Eq. (1.1) with RotorS's positions: roll l (T1 - T3), pitch l (T2 - T0), yaw ratio (T0 -
  // T1 + T2 - T3).
  const VehicleModel m = hummingbird();
  const std::vector<double> w = {400, 410, 430, 460};
  const Outcome out = fly(m, 0.001, 1, w, w);
  double T[4];
  for (std::size_t i = 0; i < 4; ++i) T[i] = 8.54858e-06 * w[i] * w[i];
  EXPECT_NEAR(out.load.torque_B.x(), 0.17 * (T[1] - T[3]), 1e-15);
  EXPECT_NEAR(out.load.torque_B.y(), 0.17 * (T[2] - T[0]), 1e-15);
  EXPECT_NEAR(out.load.torque_B.z(), 0.016 * (T[0] - T[1] + T[2] - T[3]), 1e-15);
  EXPECT_NEAR(out.load.momentum_end_B.z(), m.rotors[0].axial_inertia * (-400 + 410 - 430 + 460),
              1e-18);
}

TEST(Rotor, HForceOpposesTheMotionAcrossTheAxisOnly) {
  const VehicleModel m = hummingbird();
  const double w = 457.72, c = 8.06428e-05;
  const std::vector<double> all = {w, w, w, w};
  const double lift = fly(m, 0.001, 1, all, all).load.force_B.z();
  const Outcome sideways = fly(m, 0.001, 1, all, all, Vector3d(2, -1, 5));
  EXPECT_NEAR(sideways.load.force_B.x(), -4 * w * c * 2, 1e-15);
  EXPECT_NEAR(sideways.load.force_B.y(), 4 * w * c * 1, 1e-15);
  EXPECT_EQ(sideways.load.force_B.z(), lift);  // no drag along the axis
  EXPECT_NEAR(4 * w * c, 0.1476, 5e-5);        // [N s/m], as printed in the survey of RotorS
  // Yawing, each hub moves at w_z l across its arm.
  const Outcome yawing = fly(m, 0.001, 1, all, all, Vector3d::Zero(), Vector3d(0, 0, 3));
  EXPECT_NEAR(yawing.load.torque_B.z(), -4 * w * c * 3 * 0.17 * 0.17, 1e-15);
}

TEST(Rotor, RollingMomentHasTheTurningDirection) {
  VehicleModel m = hummingbird();
  for (RotorModel& r : m.rotors) r.drag_coefficient = 0;
  const Vector3d v(2, 0, 0);
  const auto torque = [&](const std::vector<double>& w) {
    return (fly(m, 0.001, 1, w, w, v).load.torque_B - fly(m, 0.001, 1, w, w).load.torque_B).eval();
  };
  EXPECT_NEAR(torque({400, 400, 400, 400}).norm(), 0, 1e-17);       // cancels in balance
  EXPECT_NEAR(torque({400, 0, 0, 0}).x(), +400 * 1e-6 * 2, 1e-17);  // clockwise: s = -1
  EXPECT_NEAR(torque({0, 400, 0, 0}).x(), -400 * 1e-6 * 2, 1e-17);
}

TEST(Rotor, UprightShortCutEqualsTheGeneralFormula) {
  // The same vehicle described in axes turned about y, so that no axis is exactly z; loads turned
  // back must agree.
  const VehicleModel upright = hummingbird();
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.3, Vector3d::UnitY()).toRotationMatrix();
  VehicleModel tilted = upright;
  tilted.com_B = R * upright.com_B;
  for (RotorModel& r : tilted.rotors) {
    r.position_B = R * r.position_B;
    r.axis_B = R * r.axis_B;
  }
  const std::vector<double> start = {100, 600, 838, 0}, command = {500, 200, 0, 838};
  const Vector3d v(1, -2, 3), w(0.5, -0.3, 1);
  const Outcome a = fly(upright, 0.001, 50, start, command, v, w);
  const Outcome b = fly(tilted, 0.001, 50, start, command, R * v, R * w);
  EXPECT_LT((R * a.load.force_B - b.load.force_B).norm(), 100 * 10 * kEps);
  EXPECT_LT((R * a.load.torque_B - b.load.torque_B).norm(), 100 * 10 * kEps);
  EXPECT_LT((R * a.load.momentum_mean_B - b.load.momentum_mean_B).norm(), 100 * 10 * kEps);
  EXPECT_LT((R * a.load.momentum_end_B - b.load.momentum_end_B).norm(), 100 * 10 * kEps);
}

}  // namespace
}  // namespace quad_sim
