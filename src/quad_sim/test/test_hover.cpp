// Acceptance: hovering under a geometric position controller that believes another mass and another
// g, as RotorS's does; and the range of steps and gravities.
#include <gtest/gtest.h>

#include <cmath>

#include "hummingbird.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Lee's geometric controller with the gains and figures RotorS gives its Hummingbird: no integral
/// action.
class GeometricController {
 public:
  GeometricController(Vector3d target, double yaw) : target_(std::move(target)), yaw_(yaw) {
    // Torques and thrust of squared speeds; inverted once.
    constexpr double kF = 8.54858e-06, kM = 0.016, kArm = 0.17;
    Eigen::Matrix4d K;
    K << 0, kArm * kF, 0, -kArm * kF, -kArm * kF, 0, kArm * kF, 0, kM * kF, -kM * kF, kM * kF,
        -kM * kF, kF, kF, kF, kF;
    inverse_ = K.inverse();
  }

  std::vector<double> command(const Odometry& now) const {
    constexpr double kMass = 0.716, kGravity = 9.81;
    const Matrix3d R = now.q_WB.toRotationMatrix();
    const Vector3d e_p = now.p_WB - target_, e_v = R * now.v_WB_B;
    const Vector3d force = -4.0 * e_p - 2.2 * e_v + kMass * kGravity * Vector3d::UnitZ();
    const Vector3d b3 = force.normalized(), heading(std::cos(yaw_), std::sin(yaw_), 0);
    const Vector3d b2 = b3.cross(heading).normalized();
    Matrix3d wanted;
    wanted << b2.cross(b3), b2, b3;
    const Matrix3d error = 0.5 * (wanted.transpose() * R - R.transpose() * wanted);
    const Vector3d e_R(error(2, 1), error(0, 2), error(1, 0));
    const Vector3d attitude_gain(0.7, 0.7, 0.035), rate_gain(0.1, 0.1, 0.025);
    const Vector3d torque = -attitude_gain.cwiseProduct(e_R) - rate_gain.cwiseProduct(now.w_WB_B);
    Eigen::Vector4d wrench;
    wrench << torque, force.dot(R.col(2));
    const Eigen::Vector4d squares = inverse_ * wrench;
    std::vector<double> speeds;
    for (int i = 0; i < 4; ++i) speeds.push_back(std::sqrt(std::max(0.0, squares[i])));
    return speeds;
  }

 private:
  Vector3d target_;
  double yaw_;
  Eigen::Matrix4d inverse_;
};

VehicleState fly(const SimulatorOptions& options, const Vector3d& target, double yaw,
                 double seconds) {
  const VehicleModel m = hummingbird();
  Simulator s(m, options);
  const GeometricController controller(target, yaw);
  const int every = std::max(
      1, static_cast<int>(std::lround(0.01 / options.step)));  // RotorS: at each odometry, 100 Hz
  for (int k = 0; k < std::lround(seconds / (every * options.step)); ++k) {
    s.setCommand(controller.command(s.measure().odometry));
    s.advance(every);
  }
  return s.state();
}

TEST(Hover, SagsAsMuchAsMassAndGravityAreWrong) {
  for (const Multibody multibody : {Multibody::kFolded, Multibody::kHinged}) {
    for (const Profile profile : {Profile::kDefault, Profile::kRotorsCompat}) {
      SimulatorOptions options;
      options.step = profile == Profile::kDefault ? 0.001 : 0.01;
      options.multibody = multibody;
      options.profile = profile;
      const VehicleState end = fly(options, Vector3d(0, 0, 1), 0, 30);
      // (0.716 * 9.81 - 0.73103 * 9.8) / 4 = -0.0350 m; all rotors carry 0.73103 kg at 457.72
      // rad/s.
      EXPECT_NEAR(1 - end.p_WB.z(), 0.0350, 0.001);
      EXPECT_LT(end.p_WB.head<2>().norm(), 1e-3);
      EXPECT_LT(end.v_WB.norm(), 1e-3);
      for (const double w : end.rotor_speed) EXPECT_NEAR(w, 457.72, 0.05);
    }
  }
}

TEST(Hover, ReachesAWaypointAndHeading) {
  SimulatorOptions options;
  const VehicleState end = fly(options, Vector3d(1, 0.5, 1.5), M_PI / 2, 30);
  EXPECT_LT((end.p_WB - Vector3d(1, 0.5, 1.5 - 0.035)).norm(), 2e-3);
  EXPECT_LT(
      end.q_WB.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()))),
      1e-3);
}

TEST(Hover, AnyStepFromATenthToTwentyMilliseconds) {
  for (const double step : {0.0001, 0.0005, 0.002, 0.005, 0.01, 0.02}) {
    SCOPED_TRACE(step);
    SimulatorOptions options;
    options.step = step;
    const VehicleState end = fly(options, Vector3d(0, 0, 1), 0, step < 0.0002 ? 12 : 30);
    EXPECT_NEAR(1 - end.p_WB.z(), 0.0350, 0.001);
  }
}

TEST(Hover, AnyGravity) {
  for (const double gravity : {0.0, 1.62, 3.71, 9.80665, 20.0}) {
    const VehicleModel m = hummingbird();
    SimulatorOptions options;
    options.gravity = gravity;
    Simulator s(m, options);
    s.setStartState(equilibrium(m, gravity, 10));
    s.advance(5000);
    EXPECT_NEAR(s.state().p_WB.z(), 10, 1e-12) << gravity;
  }
}

TEST(Ground, RestsWithoutJitter) {
  // Two seconds at rest, every step looked at, at several steps and in both ways of modelling.
  const VehicleModel m = hummingbird();
  for (const Multibody multibody : {Multibody::kFolded, Multibody::kHinged}) {
    for (const double step : {0.0005, 0.001, 0.01}) {
      SCOPED_TRACE(testing::Message()
                   << (multibody == Multibody::kFolded ? "folded " : "hinged ") << step);
      SimulatorOptions options;
      options.step = step;
      options.multibody = multibody;
      Simulator s(m, options);
      VehicleState start = s.state();
      start.p_WB.z() = 0.1;  // RotorS's height of spawning
      s.setStartState(start);
      s.advance(static_cast<int>(std::lround(2 / step)));
      double lowest = 1, highest = 0, fastest = 0;
      for (int i = 0; i < std::lround(2 / step); ++i) {
        s.advance(1);
        lowest = std::min(lowest, s.state().p_WB.z());
        highest = std::max(highest, s.state().p_WB.z());
        fastest = std::max(fastest, s.state().v_WB.norm() + s.state().w_WB_B.norm());
      }
      EXPECT_NEAR(lowest, 0.06, 2e-5);
      EXPECT_LT(highest - lowest, 1e-6);
      EXPECT_LT(fastest, 1e-3);
    }
  }
}

}  // namespace
}  // namespace quad_sim
