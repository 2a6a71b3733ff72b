// The simulator as a whole: equilibrium, conservation laws, reset, commands, ground, the linear model, memory.
#include <gmock/gmock.h>

#include <ode/ode.h>

#include <cmath>
#include <thread>
#include <cstdlib>
#include <cstring>
#include <new>

#include "allocation_counter.hpp"
#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::HasSubstr;

SimulatorOptions inTheAir(double step = 0.001) {
  SimulatorOptions options;
  options.step = step;
  options.ground = false;
  return options;
}

/// Bits of a state, for comparison without tolerance.
std::vector<double> numbers(const VehicleState& s) {
  std::vector<double> all = {s.p_WB.x(),   s.p_WB.y(),   s.p_WB.z(),   s.q_WB.w(),     s.q_WB.x(),     s.q_WB.y(),    s.q_WB.z(),
                             s.v_WB.x(),   s.v_WB.y(),   s.v_WB.z(),   s.w_WB_B.x(),   s.w_WB_B.y(),   s.w_WB_B.z()};
  all.insert(all.end(), s.rotor_speed.begin(), s.rotor_speed.end());
  return all;
}
bool sameBits(const VehicleState& a, const VehicleState& b) {
  const std::vector<double> x = numbers(a), y = numbers(b);
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

void flyRoughly(Simulator& s, int intervals) {
  for (int i = 0; i < intervals; ++i) {
    const double a = 40.0 * std::sin(0.7 * i), b = 25.0 * std::cos(1.3 * i);
    s.setCommand({460 + a, 455 - b, 450 + b, 465 - a});
    s.advance(50);
  }
}

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
  m.inertia_B = Vector3d(0.007, 0.009, 0.013).asDiagonal();  // three different moments: a real tumble
  SimulatorOptions options = inTheAir();
  options.gravity = 0;
  Simulator s(m, options);
  VehicleState start;
  start.w_WB_B = Vector3d(0.1, 12, 0.2);  // about the middle axis: unstable
  start.rotor_speed.assign(4, 0.0);
  s.setStartState(start);
  const auto momentum = [&](const VehicleState& x) { return (x.q_WB * (m.inertia_B * x.w_WB_B)).eval(); };
  const auto energy = [&](const VehicleState& x) { return 0.5 * x.w_WB_B.dot(m.inertia_B * x.w_WB_B); };
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
  // Kick and drift by the midpoint: exact for constant acceleration, 2000 roundings of numbers up to 20.
  EXPECT_NEAR(s.state().p_WB.z(), 3 * 2 - 0.5 * 9.8 * 4, 1e-12);
  EXPECT_NEAR(s.state().v_WB.z(), 3 - 9.8 * 2, 1e-12);
}

TEST(Simulator, ResetGivesTheSameBits) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  s.setStartState(equilibrium(m, 9.8, 10));
  flyRoughly(s, 40);
  const VehicleState first = s.state();
  EXPECT_GT(first.w_WB_B.norm(), 0.1) << "a flight that does nothing shows nothing";
  s.reset();
  EXPECT_EQ(s.timeNanoseconds(), 0);
  EXPECT_EQ(s.command(), equilibrium(m, 9.8, 10).rotor_speed);
  flyRoughly(s, 40);
  EXPECT_TRUE(sameBits(s.state(), first));
  Simulator fresh(m, SimulatorOptions{});
  fresh.setStartState(equilibrium(m, 9.8, 10));
  flyRoughly(fresh, 40);
  EXPECT_TRUE(sameBits(fresh.state(), first));
}

TEST(Simulator, HowAFlightIsCutIntoAdvancesDoesNotMatter) {
  const VehicleModel m = hummingbird();
  Simulator a(m, inTheAir()), b(m, inTheAir());
  a.setCommand({500, 510, 520, 505});
  b.setCommand({500, 510, 520, 505});
  a.advance(1000);
  for (int i = 0; i < 1000; ++i) b.advance(1);
  EXPECT_TRUE(sameBits(a.state(), b.state()));
}

TEST(Simulator, WorldsDoNotDisturbEachOther) {
  // Both on the ground, where ODE draws random numbers from a generator of the process.
  const VehicleModel m = hummingbird();
  VehicleState tilted;
  tilted.p_WB.z() = 0.2;
  tilted.q_WB = Eigen::AngleAxisd(0.6, Vector3d(1, 0.5, 0).normalized());
  tilted.rotor_speed.assign(4, 0.0);
  Simulator alone(m, SimulatorOptions{}), a(m, SimulatorOptions{}), b(m, SimulatorOptions{});
  for (Simulator* s : {&alone, &a, &b}) s->setStartState(tilted);
  alone.advance(600);
  for (int i = 0; i < 600; ++i) {
    a.advance(1);
    b.advance(1);
  }
  EXPECT_TRUE(alone.groundContact());
  EXPECT_TRUE(sameBits(alone.state(), a.state()));
  EXPECT_TRUE(sameBits(alone.state(), b.state()));
}

TEST(Simulator, WorldsInThreadsOfTheirOwnDoNotDisturbEachOtherEither) {
  const VehicleModel m = hummingbird();
  VehicleState tilted;
  tilted.p_WB.z() = 0.2;
  tilted.q_WB = Eigen::AngleAxisd(0.6, Vector3d(1, 0.5, 0).normalized());
  tilted.rotor_speed.assign(4, 0.0);
  constexpr int kSteps = 3000;  // most of them in contact, so that the threads meet there
  Simulator alone(m, SimulatorOptions{}), a(m, SimulatorOptions{}), b(m, SimulatorOptions{});
  for (Simulator* s : {&alone, &a, &b}) s->setStartState(tilted);
  alone.advance(kSteps);
  std::thread other([&] { a.advance(kSteps); });
  b.advance(kSteps);
  other.join();
  EXPECT_TRUE(sameBits(alone.state(), a.state()));
  EXPECT_TRUE(sameBits(alone.state(), b.state()));
}

TEST(Simulator, ResetWorldKeepsTheTime) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  s.setStartState(equilibrium(m, 9.8, 10));
  flyRoughly(s, 4);
  s.resetWorld();
  EXPECT_EQ(s.timeNanoseconds(), 200000000);
  EXPECT_EQ(s.state().p_WB.z(), 10);
  EXPECT_EQ(s.command(), equilibrium(m, 9.8, 10).rotor_speed);
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
  // The lowest corner falls 1 m - its depth below the origin: first contact at sqrt(2 d / g), a step's rounding up.
  const double depth = (start.q_WB * Vector3d(0.05, -0.05, -0.06)).z();
  const double lowest = std::min({(start.q_WB * Vector3d(0.05, 0.05, -0.06)).z(), (start.q_WB * Vector3d(-0.05, 0.05, -0.06)).z(),
                                  (start.q_WB * Vector3d(-0.05, -0.05, -0.06)).z(), depth});
  EXPECT_NEAR(static_cast<double>(*s.groundContactTime()) * 1e-9, std::sqrt(2 * (1 + lowest) / 9.8), 0.002);
  EXPECT_LT(s.state().v_WB.norm() + s.state().w_WB_B.norm(), 1e-3);
  EXPECT_GT(s.state().p_WB.z(), 0.049);  // on a side (0.05) or upright (0.06)
  EXPECT_LT(s.state().p_WB.z(), 0.061);
}

TEST(Simulator, CommandsAreChecked) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  const double nan = std::nan("");
  s.setCommand({100, 200, 300, 400});
  EXPECT_THAT(complaint<quad_support::DataError>([&] { s.setCommand({1, 2, 3}); }), HasSubstr("3 rotor speeds; the vehicle has 4"));
  EXPECT_THAT(complaint<quad_support::DataError>([&] { s.setCommand({1, 2, 3, nan}); }), HasSubstr("not a finite number"));
  EXPECT_EQ(s.command(), (std::vector<double>{100, 200, 300, 400}));
  s.setCommand({-5, 900, 838, 0});
  EXPECT_EQ(s.command(), (std::vector<double>{0, 838, 838, 0}));
  EXPECT_EQ(s.commandCounts().accepted, 2);
  EXPECT_EQ(s.commandCounts().clamped, 1);
  EXPECT_EQ(s.commandCounts().refused, 2);
}

TEST(Simulator, OptionsAreChecked) {
  const VehicleModel m = hummingbird();
  const auto says = [&](auto change) {
    SimulatorOptions options;
    change(options);
    return complaint<std::invalid_argument>([&] { Simulator(m, options); });
  };
  EXPECT_THAT(says([](auto& o) { o.step = 1e-10; }), HasSubstr("whole number of nanoseconds"));
  EXPECT_THAT(says([](auto& o) { o.step = 0; }), HasSubstr("simulation.step = 0 s"));
  EXPECT_THAT(says([](auto& o) { o.step = std::nan(""); }), HasSubstr("simulation.step"));
  EXPECT_THAT(says([](auto& o) { o.gravity = -1; }), HasSubstr("simulation.gravity = -1"));
}

TEST(Simulator, StatesAreChecked) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  const auto says = [&](auto change) {
    VehicleState state = equilibrium(m, 9.8, 1);
    change(state);
    return complaint<std::invalid_argument>([&] { s.setState(state); });
  };
  EXPECT_THAT(says([](auto& x) { x.p_WB.x() = std::nan(""); }), HasSubstr("finite"));
  EXPECT_THAT(says([](auto& x) { x.q_WB.coeffs().setZero(); }), HasSubstr("quaternion"));
  EXPECT_THAT(says([](auto& x) { x.rotor_speed.pop_back(); }), HasSubstr("3 rotor speeds"));
  EXPECT_THAT(says([](auto& x) { x.rotor_speed[2] = 839; }), HasSubstr("rotor_speed[2] = 839"));
}

TEST(Simulator, AStateThatIsNoLongerFiniteIsAnError) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  VehicleState wild = equilibrium(m, 9.8, 1);
  wild.v_WB.z() = 1.7e308;  // doubles end at 1.8e308
  s.setState(wild);
  EXPECT_THAT(complaint<quad_support::SimulationError>([&] { s.advance(2000); }), HasSubstr("no longer finite at 2 s"));
  for (double rate : {1e4, 1e200}) {
    wild = equilibrium(m, 9.8, 1);
    wild.w_WB_B.x() = rate;
    s.setState(wild);
    EXPECT_THAT(complaint<quad_support::SimulationError>([&] { s.advance(10); }), HasSubstr("more than a radian in a step"));
  }
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
  EXPECT_LT((s.odometry(mast).v_WB_B - (Vector3d(0, -2, 1) + state.w_WB_B.cross(Vector3d(0, 0, 0.5)))).norm(), 1e-15);
}

TEST(Simulator, SpecificForceIsAccelerationLessGravity) {
  const VehicleModel m = hummingbird();
  Simulator s(m, inTheAir());
  SensorModel sensor;
  EXPECT_EQ(s.specificForce(sensor), Vector3d(0, 0, 9.8));  // before any step: at rest
  s.advance(10);                                            // rotors still: free fall
  EXPECT_LT(s.specificForce(sensor).norm(), 1e-12);         // differences of velocities up to 0.1 over 1e-3
  VehicleState state = equilibrium(m, 9.8, 10);
  state.q_WB = Eigen::AngleAxisd(0.3, Vector3d::UnitX());
  s.setState(state);
  s.setCommand(state.rotor_speed);
  s.advance(1);
  // Thrust acts along the body's z alone, whatever the attitude; the sensor turned about x by 90 degrees has it on y.
  EXPECT_LT((s.specificForce(sensor) - Vector3d(0, 0, 9.8)).norm(), 1e-3);  // drag: 0.2 1/s times the first step's 3e-3 m/s
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
  // Flying with the wind is hovering: the same velocity change as without wind at rest, none; and against Galilei's reference.
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
  EXPECT_LT((carried.state().p_WB - still.state().p_WB - 0.5 * wind).norm(), 1e-12);  // rounding of 500 steps
  EXPECT_LT((carried.state().w_WB_B - still.state().w_WB_B).norm(), 1e-12);
  EXPECT_EQ(carried.wind(), wind);
  carried.reset();
  EXPECT_EQ(carried.wind(), Vector3d::Zero());
  EXPECT_THAT(complaint<std::invalid_argument>([&] { carried.setWind(Vector3d(0, std::nan(""), 0)); }), HasSubstr("finite"));
}

using test::AllocationCounter;

TEST(AllocationCounter, SeesEveryWayToTheHeap) {
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  const auto counted = [](auto allocate) {
    AllocationCounter counter;
    void* volatile p = allocate();  // volatile: the compiler may not leave the pair out
    const long count = counter.count();
    std::free(p);
    return count;
  };
  EXPECT_EQ(counted([] { return static_cast<void*>(nullptr); }), 0);
  EXPECT_EQ(counted([] { return std::malloc(8); }), 1);
  EXPECT_EQ(counted([] { return std::calloc(2, 8); }), 1);
  EXPECT_EQ(counted([] { return std::realloc(nullptr, 8); }), 1);
  EXPECT_EQ(counted([] { return std::aligned_alloc(64, 64); }), 1);
  EXPECT_EQ(counted([] {
    void* p = nullptr;
    return posix_memalign(&p, 64, 64) == 0 ? p : nullptr;
  }), 1);
  AllocationCounter counter;
  ::operator delete(::operator new(8));
  ::operator delete(::operator new(64, std::align_val_t(64)), std::align_val_t(64));
  EXPECT_EQ(counter.count(), 2);
  const Eigen::VectorXd vector = Eigen::VectorXd::Zero(3);
  EXPECT_EQ(counter.count(), 3) << vector;
  dFree(dAlloc(8), 8);  // ODE's own way, from within its library
  EXPECT_GE(counter.count(), 4);
}

/// Allocations of 100 intervals of 100 steps, one command and one measurement each, after `warm_up` steps.
long allocationsInFlight(double altitude, double speed, int warm_up) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions{});
  VehicleState start = equilibrium(m, 9.8, altitude);
  start.rotor_speed.assign(4, speed);
  s.setStartState(start);
  Measurement measurement = s.measure();
  std::vector<double> command = start.rotor_speed;
  command[0] += 3;
  s.advance(warm_up);
  AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    s.setCommand(command);
    s.advance(100);
    s.measure(measurement);
  }
  return counter.count();
}

TEST(Simulator, AStepAllocatesNothing) {
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  // From high enough not to touch the ground in these 10 s: the first touch lets ODE reserve memory for contacts.
  EXPECT_EQ(allocationsInFlight(5000, hoverSpeed(hummingbird(), 9.8), 1), 0);
}

TEST(Simulator, AStepOnTheGroundAllocatesNothing) {
  if (!AllocationCounter::available()) GTEST_SKIP() << "a sanitizer has the heap to itself";
  // After a second the vehicle lies; ODE keeps the memory it reserved for the contacts before.
  EXPECT_EQ(allocationsInFlight(0.06, 0, 1000), 0);
}

// ---- thesis Eq. (1.5) ----

using State12 = Eigen::Matrix<double, 12, 1>;
enum { kX, kY, kZ, kVx, kVy, kVz, kPhi, kTheta, kPsi, kP, kQ, kR };

/// One short step from (X, U) around hover; the mean derivative over it. Positions are those of the centre of mass.
State12 derivative(const VehicleModel& m, const State12& X, const Eigen::Vector4d& U, double h) {
  VehicleState s;
  s.q_WB = Eigen::AngleAxisd(X[kPsi], Vector3d::UnitZ()) * Eigen::AngleAxisd(X[kTheta], Vector3d::UnitY()) *
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
  for (int i = 0; i < 4; ++i) s.rotor_speed.push_back(std::sqrt(thrust[i] / m.rotors[0].thrust_coefficient));
  SimulatorOptions options = inTheAir(h);
  Simulator simulator(m, options);
  simulator.setStartState(s);  // the command follows: no lag
  simulator.advance(1);
  const VehicleState e = simulator.state();
  const Matrix3d R = e.q_WB.toRotationMatrix();
  State12 X1;
  X1 << e.p_WB + R * m.com_B, e.v_WB + R * e.w_WB_B.cross(m.com_B), std::atan2(R(2, 1), R(2, 2)), -std::asin(R(2, 0)),
      std::atan2(R(1, 0), R(0, 0)), e.w_WB_B;
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
  // What Eq. (1.5) leaves out: the rotors' H-force, D v at height a above the centre of mass. In RotorS's model it is there.
  const double w = hoverSpeed(m, g);
  const double D = 4 * m.rotors[0].drag_coefficient * w, a = m.rotors[0].position_B.z() - m.com_B.z(), l = 0.17;
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
    B_found.col(j) = (derivative(m, State12::Zero(), U0 + e, h) - derivative(m, State12::Zero(), U0 - e, h)) / (2 * du);
  }
  // A mean over h differs from the derivative by (h/2) A² and (h/2) A B: up to 5e-6 and 7e-4 here. Central differences add
  // dx² times third derivatives, about 1e-5, rounding 1e-16/(h dx) = 1e-7.
  EXPECT_LT((A_found - A).cwiseAbs().maxCoeff(), 3e-5) << A_found - A;
  EXPECT_LT((B_found - B).cwiseAbs().maxCoeff(), 1e-3) << B_found - B;
}

}  // namespace
}  // namespace quad_sim
