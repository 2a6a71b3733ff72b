// Motion of the whole vehicle against laws of mechanics: equilibrium, conservation, free fall,
// ground, measurement.
#include <gmock/gmock.h>

#include <cmath>

#include "hummingbird.hpp"
#include "in_the_air.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

TEST(Simulator, HoversWhereItStarts) {
  const VehicleModel m = loadVehicle(hummingbirdPath(), 0.73);
  Simulator s(m, inTheAir());
  s.setStartState(equilibrium(m, 9.8, 5000));
  s.advance(43000);
  // The hover speed is rounded to 1 part in 1e16, so the vehicle may accelerate by 1e-15 m/s².
  EXPECT_NEAR(s.state().p_WB.z(), 5000, 1e-15 * 43 * 43);
  EXPECT_EQ(s.timeNanoseconds(), 43000000000);
}

TEST(Simulator, TumblingConservesMomentumAndEnergy) {
  VehicleModel m = hummingbird();
  m.inertia_B =
      Vector3d(0.007, 0.009, 0.013).asDiagonal();  // three different moments: a real tumble
  SimulatorOptions options = inTheAir();
  options.gravity = 0;
  Simulator s(m, options);
  VehicleState start;
  start.w_WB_B = Vector3d(0.1, 12, 0.2);  // about the middle axis: unstable
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  const auto momentum = [&](const VehicleState& x) {
    return (x.q_WB * (m.inertia_B * x.w_WB_B)).eval();
  };
  const auto energy = [&](const VehicleState& x) {
    return 0.5 * x.w_WB_B.dot(m.inertia_B * x.w_WB_B);
  };
  const Vector3d L0 = momentum(start);
  const double E0 = energy(start);
  double worst_L = 0, worst_E = 0, least_wy = 12;
  for (int i = 0; i < 1000; ++i) {
    s.advance(20);
    const VehicleState now = s.state();
    worst_L = std::max(worst_L, (momentum(now) - L0).norm() / L0.norm());
    worst_E = std::max(worst_E, std::abs(energy(now) - E0) / E0);
    least_wy = std::min(least_wy, now.w_WB_B.y());
  }
  EXPECT_LT(least_wy, -11) << "the vehicle must have turned over, else this test shows nothing";
  EXPECT_LT(worst_L, 1e-14);  // kept in world axes; only the conversion rounds. Measured 2.4e-15
  EXPECT_LT(worst_E, 1e-12);  // 20 000 steps, each iterated to 1e-13 of the rate. Measured 5.1e-15
}

TEST(Simulator, SpinningUpARotorTurnsTheBodyBack) {
  // One rotor without drag torque and thrust: total angular momentum about the axis stays zero.
  VehicleModel m = hummingbird();
  for (RotorModel& r : m.rotors) {
    r.torque_ratio = 0;
    r.thrust_coefficient = 1e-30;
    r.drag_coefficient = r.rolling_moment_coefficient = 0;
  }
  Simulator s(m, inTheAir());
  VehicleState start;
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.setCommand({0, 500, 0, 0});
  s.advance(500);
  const VehicleState end = s.state();
  const double rotor = m.rotors[1].axial_inertia * end.rotor_speed[1];
  EXPECT_NEAR(m.inertia_B(2, 2) * end.w_WB_B.z(), -rotor, 1e-15);
  EXPECT_GT(rotor, 3e-3);
}

TEST(Simulator, FreeFallIsExact) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  VehicleState start;
  start.v_WB = Vector3d(0, 0, 3);
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.advance(2000);
  // Kick and drift by the midpoint: exact for constant acceleration, 2000 roundings of numbers up
  // to 20.
  EXPECT_NEAR(s.state().p_WB.z(), 3 * 2 - 0.5 * 9.8 * 4, 1e-12);
  EXPECT_NEAR(s.state().v_WB.z(), 3 - 9.8 * 2, 1e-12);
}

TEST(Simulator, RestsOnTheGround) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  EXPECT_EQ(s.state().p_WB.z(), 0.06);
  EXPECT_FALSE(s.groundContact());
  s.advance(2000);
  // It keeps within the contact layer of 10 micrometres.
  EXPECT_NEAR(s.state().p_WB.z(), 0.06, 1e-5);
  EXPECT_LT(s.state().v_WB.norm(), 1e-6);
  EXPECT_EQ(s.groundContactTime(), 1000000);
}

TEST(Simulator, FallsOnTheGroundAndComesToRest) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  VehicleState start;
  start.p_WB.z() = 1;
  start.q_WB = Eigen::AngleAxisd(0.5, Vector3d(1, 1, 0).normalized());
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  s.advance(5000);
  ASSERT_TRUE(s.groundContact());
  // The lowest corner falls 1 m - its depth below the origin: first contact at sqrt(2 d / g), a
  // step's rounding up.
  const double depth = (start.q_WB * Vector3d(0.05, -0.05, -0.06)).z();
  const double lowest = std::min({(start.q_WB * Vector3d(0.05, 0.05, -0.06)).z(),
                                  (start.q_WB * Vector3d(-0.05, 0.05, -0.06)).z(),
                                  (start.q_WB * Vector3d(-0.05, -0.05, -0.06)).z(), depth});
  EXPECT_NEAR(static_cast<double>(*s.groundContactTime()) * 1e-9, std::sqrt(2 * (1 + lowest) / 9.8),
              0.002);
  EXPECT_LT(s.state().v_WB.norm() + s.state().w_WB_B.norm(), 1e-3);
  EXPECT_GT(s.state().p_WB.z(), 0.049);  // on a side (0.05) or upright (0.06)
  EXPECT_LT(s.state().p_WB.z(), 0.061);
}

TEST(Simulator, OdometryTwistIsInBodyAxes) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  VehicleState state = equilibrium(m, 9.8, 3);
  state.q_WB = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ());
  state.v_WB = Vector3d(2, 0, 1);
  state.w_WB_B = Vector3d(0.1, 0.2, 0.3);
  s.setState(state);
  const Measurement now = s.measure();
  EXPECT_LT((now.odometry.v_WB_B - Vector3d(0, -2, 1)).norm(), 1e-15);
  EXPECT_LT((now.odometry.w_WB_B - state.w_WB_B).norm(), 1e-15);
  EXPECT_EQ(now.rotor_speed, state.rotor_speed);
  SensorModel mast;
  mast.X_BS.translation() = Vector3d(0, 0, 0.5);
  EXPECT_LT(
      (s.odometry(mast).v_WB_B - (Vector3d(0, -2, 1) + state.w_WB_B.cross(Vector3d(0, 0, 0.5))))
          .norm(),
      1e-15);
}

TEST(Simulator, SpecificForceIsAccelerationLessGravity) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  SensorModel sensor;
  EXPECT_EQ(s.specificForce(sensor), Vector3d(0, 0, 9.8));  // before any step: at rest
  s.advance(10);                                            // rotors still: free fall
  EXPECT_LT(s.specificForce(sensor).norm(),
            1e-12);  // differences of velocities up to 0.1 over 1e-3
  VehicleState state = equilibrium(m, 9.8, 10);
  state.q_WB = Eigen::AngleAxisd(0.3, Vector3d::UnitX());
  s.setState(state);
  s.setCommand(state.rotor_speed);
  s.advance(1);
  // Thrust acts along the body's z alone, whatever the attitude; the sensor turned about x by 90
  // degrees has it on y.
  EXPECT_LT((s.specificForce(sensor) - Vector3d(0, 0, 9.8)).norm(),
            1e-3);  // drag: 0.2 1/s times the first step's 3e-3 m/s
  sensor.X_BS.linear() = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).toRotationMatrix();
  EXPECT_LT((s.specificForce(sensor) - Vector3d(0, 9.8, 0)).norm(), 1e-3);
  // Spinning about z, a sensor 0.5 m out feels w² r inwards, and the yaw damping's tangential part.
  state = equilibrium(m, 9.8, 10);
  state.w_WB_B.z() = 4;
  s.setState(state);
  s.advance(1);
  sensor.X_BS = Eigen::Isometry3d::Identity();
  sensor.X_BS.translation() = Vector3d(0.5, 0, 0);
  const double damping = 4 * 8.06428e-05 * hoverSpeed(m, 9.8) * 0.17 * 0.17 * 4 / m.inertia_B(2, 2);
  // The mean over the step differs by h times the rate of change: 1 ms of a damping of 0.3 1/s.
  EXPECT_NEAR(s.specificForce(sensor).x(), -16 * 0.5, 16 * 0.5 * 1e-3);
  EXPECT_NEAR(s.specificForce(sensor).y(), -damping * 0.5, 1e-3 * damping);
}

TEST(Simulator, OnlyMotionThroughTheAirCounts) {
  // Flying with the wind is hovering: the same velocity change as without wind at rest, none; and
  // against Galilei's reference.
  const VehicleModel m = hummingbird();
  const Vector3d wind(3, -2, 0);
  Simulator still(m, inTheAir()), carried(m, inTheAir());
  VehicleState start = equilibrium(m, 9.8, 10);
  start.w_WB_B = Vector3d(0.1, 0.2, -0.1);
  still.setStartState(start);
  start.v_WB += wind;
  carried.setStartState(start);
  carried.setWind(wind);
  for (Simulator* s : {&still, &carried}) s->advance(500);
  EXPECT_LT((carried.state().p_WB - still.state().p_WB - 0.5 * wind).norm(),
            1e-12);  // rounding of 500 steps
  EXPECT_LT((carried.state().w_WB_B - still.state().w_WB_B).norm(), 1e-12);
  EXPECT_EQ(carried.wind(), wind);
  carried.reset();
  EXPECT_EQ(carried.wind(), Vector3d::Zero());
  EXPECT_THAT(
      complaint<std::invalid_argument>([&] { carried.setWind(Vector3d(0, std::nan(""), 0)); }),
      HasSubstr("finite"));
}

}  // namespace
}  // namespace quad_sim
