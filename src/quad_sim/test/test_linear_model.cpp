// The simulator near hover is the linear model of thesis Eq. (1.5).
#include <gtest/gtest.h>

#include <cmath>

#include "hummingbird.hpp"
#include "in_the_air.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using State12 = Eigen::Matrix<double, 12, 1>;
enum { kX, kY, kZ, kVx, kVy, kVz, kPhi, kTheta, kPsi, kP, kQ, kR };

/// One short step from (X, U) around hover; the mean derivative over it. Positions are those of the
/// centre of mass.
State12 derivative(const VehicleModel& m, const State12& X, const Eigen::Vector4d& U, double h) {
  VehicleState s;
  s.q_WB = Eigen::AngleAxisd(X[kPsi], Vector3d::UnitZ()) *
           Eigen::AngleAxisd(X[kTheta], Vector3d::UnitY()) *
           Eigen::AngleAxisd(X[kPhi], Vector3d::UnitX());
  s.w_WB_B = X.segment<3>(kP);  // equal to the angles' rates to first order
  s.p_WB = X.segment<3>(kX) - s.q_WB * m.com_B;
  s.v_WB = X.segment<3>(kVx) - s.q_WB * s.w_WB_B.cross(m.com_B);
  Eigen::Matrix4d K;  // thrusts to wrench, from positions and spins
  for (int i = 0; i < 4; ++i) {
    const RotorModel& r = m.rotors[static_cast<std::size_t>(i)];
    K.col(i) << 1, r.position_B.y(), -r.position_B.x(), -r.spin * r.torque_ratio;
  }
  const Eigen::Vector4d thrust = K.inverse() * U;
  for (int i = 0; i < 4; ++i)
    s.rotor_speed.push_back(std::sqrt(thrust[i] / m.rotors[0].thrust_coefficient));
  SimulatorOptions options = inTheAir(h);
  Simulator simulator(m, options);
  simulator.setStartState(s);  // the command follows: no lag
  simulator.advance(1);
  const VehicleState e = simulator.state();
  const Matrix3d R = e.q_WB.toRotationMatrix();
  State12 X1;
  X1 << e.p_WB + R * m.com_B, e.v_WB + R * e.w_WB_B.cross(m.com_B), std::atan2(R(2, 1), R(2, 2)),
      -std::asin(R(2, 0)), std::atan2(R(1, 0), R(0, 0)), e.w_WB_B;
  return (X1 - X) / h;
}

TEST(Simulator, LinearModelIsThatOfTheThesis) {
  const VehicleModel m = loadVehicle(hummingbirdPath(), 0.73);
  const double g = 9.8, h = 1e-6;
  const Vector3d I = m.inertia_B.diagonal();
  Eigen::Matrix<double, 12, 12> A = Eigen::Matrix<double, 12, 12>::Zero(), A_found;
  Eigen::Matrix<double, 12, 4> B = Eigen::Matrix<double, 12, 4>::Zero(), B_found;
  // Eq. (1.5).
  for (int i = 0; i < 3; ++i) A(kX + i, kVx + i) = A(kPhi + i, kP + i) = 1;
  A(kVx, kTheta) = g;
  A(kVy, kPhi) = -g;
  B(kVz, 0) = 1 / m.mass;
  for (int i = 0; i < 3; ++i) B(kP + i, 1 + i) = 1 / I[i];
  // What Eq. (1.5) leaves out: the rotors' H-force, D v at height a above the centre of mass. In
  // RotorS's model it is there.
  const double w = hoverSpeed(m, g);
  const double D = 4 * m.rotors[0].drag_coefficient * w,
               a = m.rotors[0].position_B.z() - m.com_B.z(), l = 0.17;
  A(kVx, kVx) = A(kVy, kVy) = -D / m.mass;
  A(kVx, kQ) = -D * a / m.mass;
  A(kVy, kP) = D * a / m.mass;
  A(kP, kVy) = D * a / I[0];
  A(kP, kP) = -D * a * a / I[0];
  A(kQ, kVx) = -D * a / I[1];
  A(kQ, kQ) = -D * a * a / I[1];
  A(kR, kR) = -D * l * l / I[2];

  const Eigen::Vector4d U0(m.mass * g, 0, 0, 0);
  const double dx = 1e-3, du = 1e-3;
  for (int j = 0; j < 12; ++j) {
    const State12 e = dx * State12::Unit(j);
    A_found.col(j) = (derivative(m, e, U0, h) - derivative(m, -e, U0, h)) / (2 * dx);
  }
  for (int j = 0; j < 4; ++j) {
    const Eigen::Vector4d e = du * Eigen::Vector4d::Unit(j);
    B_found.col(j) =
        (derivative(m, State12::Zero(), U0 + e, h) - derivative(m, State12::Zero(), U0 - e, h)) /
        (2 * du);
  }
  // A mean over h differs from the derivative by (h/2) A² and (h/2) A B: up to 5e-6 and 7e-4 here.
  // Central differences add dx² times third derivatives, about 1e-5, rounding 1e-16/(h dx) = 1e-7.
  EXPECT_LT((A_found - A).cwiseAbs().maxCoeff(), 3e-5) << A_found - A;
  EXPECT_LT((B_found - B).cwiseAbs().maxCoeff(), 1e-3) << B_found - B;
}

}  // namespace
}  // namespace quad_sim
