#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <string>

#include "hummingbird.hpp"
#include "quad_control/mixer.hpp"
#include "quad_support/errors.hpp"

namespace quad_control {
namespace {

using test::hummingbirdRotors;
using test::kArm;
using test::kMaxSpeed;
using test::kMomentConstant;
using test::kThrustCoefficient;

constexpr double kEps = std::numeric_limits<double>::epsilon();

std::vector<RotorGeometry> hexacopter() {
  std::vector<RotorGeometry> rotors;
  for (int i = 0; i < 6; ++i) {
    const double angle = (i + 0.5) * 3.14159265358979323846 / 3.0;
    rotors.push_back({{0.215 * std::cos(angle), 0.215 * std::sin(angle), 0.037},
                      Eigen::Vector3d::UnitZ(),
                      i % 2 == 0 ? 1 : -1,
                      kThrustCoefficient,
                      kMomentConstant,
                      kMaxSpeed});
  }
  return rotors;
}

std::string messageOf(const std::vector<RotorGeometry>& rotors) {
  try {
    Mixer mixer(rotors);
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

// Thesis Eq. (1.3), typed here and nowhere else: rotor 1 ... 4 at front, right, back, left.
Eigen::Matrix4d thesisMatrix() {
  const double kf = kThrustCoefficient, km = kf * kMomentConstant, l = kArm;
  Eigen::Matrix4d K;
  K << kf, kf, kf, kf, 0, -l * kf, 0, l * kf, -l * kf, 0, l * kf, 0, -km, km, -km, km;
  return K;
}

TEST(Mixer, RollAndYawRowsOppositeToThesisOnRotorSOrder) {
  const Eigen::Matrix4d K = Mixer(hummingbirdRotors()).matrix();
  const Eigen::Matrix4d thesis = thesisMatrix();
  const char* const rows[4] = {"thrust", "roll  ", "pitch ", "yaw   "};
  const double expected[4] = {1.0, -1.0, 1.0, -1.0};
  for (int row = 0; row < 4; ++row) {
    // Products of two factors, rounded in another order.
    const bool same = (K.row(row) - thesis.row(row)).norm() <= 4 * kEps * thesis.row(row).norm();
    const bool opposite =
        (K.row(row) + thesis.row(row)).norm() <= 4 * kEps * thesis.row(row).norm();
    std::cout << "K against Eq. (1.3), rotors front, left, back, right: " << rows[row]
              << (same       ? " equal"
                  : opposite ? " opposite sign"
                             : " different")
              << '\n';
    EXPECT_TRUE(expected[row] > 0 ? same : opposite) << rows[row];
  }
}

TEST(Mixer, IsTheThesisMatrixForItsNumberingAndSpins) {
  std::vector<RotorGeometry> rotors = hummingbirdRotors();
  std::swap(rotors[1], rotors[3]);  // front, right, back, left
  for (int i = 0; i < 4; ++i)
    rotors[static_cast<std::size_t>(i)].spin = i % 2 == 0 ? 1 : -1;  // the front one ccw
  const Eigen::Matrix4d K = Mixer(rotors).matrix();
  EXPECT_LE((K - thesisMatrix()).norm(), 4 * kEps * thesisMatrix().norm());
}

TEST(Mixer, EqualsTheSumOfForcesAndTorquesForTiltedRotors) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<RotorGeometry> rotors = hexacopter();
    std::vector<double> speed;
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    for (RotorGeometry& rotor : rotors) {
      rotor.position_B += 0.05 * Eigen::Vector3d(unit(random), unit(random), unit(random));
      rotor.axis_B =
          (Eigen::Vector3d::UnitZ() + 0.3 * Eigen::Vector3d(unit(random), unit(random), 0))
              .normalized();
      speed.push_back(400.0 + 200.0 * unit(random));
      const Eigen::Vector3d F =
          rotor.thrust_coefficient * speed.back() * speed.back() * rotor.axis_B;
      force += F;
      torque += rotor.position_B.cross(F) - rotor.spin * rotor.moment_constant * F;
    }
    const ControlInput U = Mixer(rotors).controlInput(speed);
    // Six terms of order 10 N: some tens of roundings.
    EXPECT_NEAR(U(0), force.z(), 100 * kEps * force.norm());
    EXPECT_LE((U.tail<3>() - torque).norm(), 100 * kEps * force.norm());
  }
}

TEST(Mixer, AllocationGivesWhatWasAsked) {
  for (const auto& rotors : {hummingbirdRotors(), hexacopter()}) {
    const Mixer mixer(rotors);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int trial = 0; trial < 200; ++trial) {
      SCOPED_TRACE(trial);
      const ControlInput U(7.0 + unit(random), 0.1 * unit(random), 0.1 * unit(random),
                           0.02 * unit(random));
      const Allocation allocation = mixer.allocate(U);
      ASSERT_EQ(allocation.clamped, 0);
      // The condition number of K is about 60 (yaw lever 0.016 m against 1): 60 eps of 7 N;
      // measured 4e-15.
      EXPECT_LE((mixer.controlInput(allocation.rotor_speed) - U).norm(), 1e-13);
    }
  }
}

TEST(Mixer, HexacopterAllocationHasLeastNorm) {
  const Mixer mixer(hexacopter());
  const ControlInput U(9.0, 0.1, -0.05, 0.01);
  const std::vector<double> speed = mixer.allocate(U).rotor_speed;
  Eigen::VectorXd squares(6);
  for (int i = 0; i < 6; ++i)
    squares(i) = speed[static_cast<std::size_t>(i)] * speed[static_cast<std::size_t>(i)];
  // The solution of least norm is orthogonal to the null space of K.
  const Eigen::MatrixXd kernel = Eigen::MatrixXd(mixer.matrix()).fullPivLu().kernel();
  ASSERT_EQ(kernel.cols(), 2);
  // squares are of order 2e5; the kernel of the scaled matrix is good to about 1e-13 of that.
  EXPECT_LE((kernel.transpose() * squares).norm(), 1e-11 * squares.norm() * kernel.norm());
}

TEST(Mixer, ClampsAndCountsBothWays) {
  const Mixer mixer(hummingbirdRotors());
  // Pitch 0.17 N m at 1 N: f = 0.25 ∓ 0.5 N, so the front rotor is asked for less than nothing.
  const Allocation low = mixer.allocate({1.0, 0.0, kArm, 0.0});
  EXPECT_EQ(low.clamped, 1);
  EXPECT_EQ(low.rotor_speed[0], 0.0);
  EXPECT_NEAR(low.rotor_speed[2], std::sqrt(0.75 / kThrustCoefficient), 1e-9);
  const Allocation high = mixer.allocate({2.0 * mixer.maxThrust(), 0.0, 0.0, 0.0});
  EXPECT_EQ(high.clamped, 4);
  for (const double speed : high.rotor_speed) EXPECT_EQ(speed, kMaxSpeed);
}

TEST(Mixer, MarginIsWhereClampingBegins) {
  const Mixer mixer(hummingbirdRotors());
  const ControlInput hover(6.12206, 0, 0, 0);
  // By hand: the slower rotor stops, so each of the two gives T/4: l T/2. Yaw: four rotors, 0.016
  // T.
  EXPECT_NEAR(mixer.margin(hover, 2), kArm * 6.12206 / 2, 1e-12);
  EXPECT_NEAR(mixer.margin(hover, 3), kMomentConstant * 6.12206, 1e-12);
  for (int axis = 0; axis < 4; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const double s = mixer.margin(hover, axis);
      // One part in 1e9: far above rounding, far below any figure of the vehicle.
      const double inside = (1 - 1e-9) * s, outside = (1 + 1e-9) * s;
      EXPECT_EQ(mixer.allocate(hover + side * inside * ControlInput::Unit(axis)).clamped, 0);
      if (axis == 0) continue;  // thrust has much more room upwards than downwards
      EXPECT_GT(mixer.allocate(hover + side * outside * ControlInput::Unit(axis)).clamped, 0);
    }
  }
  EXPECT_EQ(mixer.margin({-1.0, 0, 0, 0}, 1), 0.0);
}

TEST(Mixer, MaximalThrustIsRotorS) {
  EXPECT_NEAR(Mixer(hummingbirdRotors()).maxThrust(), 24.013, 0.0005);  // printed to three decimals
}

TEST(Mixer, SingularAllocationNamesWhatIsLost) {
  std::vector<RotorGeometry> rotors = hummingbirdRotors();
  for (RotorGeometry& rotor : rotors) rotor.moment_constant = 0.0;
  EXPECT_NE(messageOf(rotors).find("rank 3 of 4, so yaw torque cannot be commanded; "),
            std::string::npos)
      << messageOf(rotors);
  rotors = hummingbirdRotors();
  for (RotorGeometry& rotor : rotors)
    rotor.spin = 1;  // the drag torques no longer cancel: yaw goes with thrust
  EXPECT_NE(messageOf(rotors).find(
                "rank 3 of 4, so thrust and yaw torque cannot be commanded independently of each "
                "other; "),
            std::string::npos)
      << messageOf(rotors);
  for (RotorGeometry& rotor : rotors) rotor.position_B.x() = 0.0;
  EXPECT_NE(
      messageOf(rotors).find(
          "rank 2 of 4, so pitch torque cannot be commanded, and thrust and yaw torque cannot "
          "be commanded independently of each other; "),
      std::string::npos)
      << messageOf(rotors);
  rotors = hummingbirdRotors();
  rotors[0].position_B.x() = rotors[2].position_B.x() = 0.0;
  for (RotorGeometry& rotor : rotors) rotor.spin = rotor.position_B.y() > 0 ? 1 : -1;
  EXPECT_NE(messageOf(rotors).find("rank"), std::string::npos);
  EXPECT_NE(messageOf(rotors).find("so pitch torque cannot be commanded; "), std::string::npos)
      << messageOf(rotors);
  rotors = hummingbirdRotors();
  rotors.pop_back();
  EXPECT_NE(
      messageOf(rotors).find(
          "3 rotors give a matrix of rank 3 of 4, so thrust, roll torque and yaw torque cannot "
          "be commanded independently of each other;"),
      std::string::npos)
      << messageOf(rotors);
  rotors.resize(2);
  EXPECT_NE(messageOf(rotors).find("2 rotors give a matrix of rank 2 of 4"), std::string::npos)
      << messageOf(rotors);
  EXPECT_NE(messageOf({}).find("0 rotors"), std::string::npos) << messageOf({});
}

TEST(Mixer, RefusesFiguresOutOfRange) {
  std::vector<RotorGeometry> rotors = hummingbirdRotors();
  rotors[2].max_speed = 0.0;
  EXPECT_EQ(messageOf(rotors), "control allocation: rotor 2: max_speed = 0; must be > 0 rad/s");
  rotors = hummingbirdRotors();
  rotors[1].axis_B *= 2.0;
  EXPECT_EQ(messageOf(rotors), "control allocation: rotor 1: |axis_B| = 2; must be 1");
  const Mixer mixer(hummingbirdRotors());
  EXPECT_THROW(mixer.controlInput({1.0, 2.0, 3.0}), quad_support::DataError);
}

}  // namespace
}  // namespace quad_control
