// Pushes from outside, and what the ground does to a vehicle.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "hummingbird.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;

SimulatorOptions with(Multibody multibody) {
  SimulatorOptions options;
  options.multibody = multibody;
  return options;
}

VehicleState highUp(const VehicleModel& model) {
  VehicleState state;
  state.p_WB.z() = 100;
  state.rotor_speed.assign(model.rotors.size(), 0.0);
  return state;
}

class OutsideLoads : public testing::TestWithParam<Multibody> {};

TEST_P(OutsideLoads, APushMovesAndTurnsByItsImpulse) {
  const VehicleModel model = hummingbird();
  Simulator simulator(model, with(GetParam()));
  simulator.setStartState(highUp(model));
  simulator.setPush({Vector3d(0.3, 0, 0), Vector3d(0, 0, 1e-3)});
  simulator.advance(200);
  simulator.setPush({});
  const VehicleState pushed = simulator.state();
  const Vector3d v_WC = pushed.v_WB + pushed.q_WB * pushed.w_WB_B.cross(model.com_B);
  // Rotors at rest drag nothing; what is left is rounding, 200 steps of it.
  EXPECT_NEAR(v_WC.x(), 0.3 * 0.2 / model.mass, 1e-12);
  EXPECT_NEAR(pushed.w_WB_B.z(), 1e-3 * 0.2 / model.inertia_B(2, 2), 1e-9);
  simulator.advance(100);
  EXPECT_NEAR(simulator.state().w_WB_B.z(), pushed.w_WB_B.z(), 1e-12);
}

TEST_P(OutsideLoads, APushKeepsTheWorldsAxes) {
  const VehicleModel model = hummingbird();
  Simulator simulator(model, with(GetParam()));
  VehicleState start = highUp(model);
  start.q_WB = Eigen::AngleAxisd(1.2, Vector3d(1, 2, 3).normalized());
  simulator.setStartState(start);
  simulator.setPush({Vector3d(0, 0.3, 0), Vector3d::Zero()});
  simulator.advance(200);
  EXPECT_NEAR(simulator.state().v_WB.y(), 0.3 * 0.2 / model.mass, 1e-12);
  EXPECT_NEAR(simulator.state().v_WB.x(), 0, 1e-12);
}

TEST_P(OutsideLoads, APushIsSavedAndForgottenByReset) {
  const VehicleModel model = hummingbird();
  Simulator simulator(model, with(GetParam())), twin(model, with(GetParam()));
  simulator.setStartState(highUp(model));
  twin.setStartState(highUp(model));
  simulator.setPush({Vector3d(0.3, 0, 0), Vector3d(0, 0, 1e-3)});
  simulator.advance(10);
  twin.restore(simulator.save());
  simulator.advance(10);
  twin.advance(10);
  EXPECT_EQ(toText(twin.save()), toText(simulator.save()));
  simulator.reset();
  simulator.advance(10);
  EXPECT_EQ(simulator.state().v_WB.x(), 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(simulator.setPush({Vector3d(nan, 0, 0), Vector3d::Zero()}), std::invalid_argument);
}

TEST_P(OutsideLoads, TheGroundCarriesAVehicleAtRest) {
  const VehicleModel model = hummingbird();
  Simulator simulator(model, with(GetParam()));
  EXPECT_EQ(simulator.groundLoad().force, Vector3d::Zero()) << "before the first step";
  simulator.advance(1000);
  const Wrench load = simulator.groundLoad();
  // A second after it was set down the soft contact (erp 0.2 a step) has come to rest.
  EXPECT_NEAR(load.force.z(), model.mass * 9.8, 1e-3);
  EXPECT_NEAR(load.force.head<2>().norm(), 0, 1e-3);
  EXPECT_NEAR(load.torque.norm(), 0, 1e-4);  // 1e-3 N at the 0.1 m of the body
  Simulator twin(model, with(GetParam()));
  twin.restore(simulator.save());
  EXPECT_EQ(twin.groundLoad().force, load.force);
  simulator.setStartState(highUp(model));
  simulator.advance(1);
  EXPECT_EQ(simulator.groundLoad().force, Vector3d::Zero());
}

TEST_P(OutsideLoads, TheGroundHoldsAgainstASidewaysPushByFriction) {
  const VehicleModel model = hummingbird();
  Simulator simulator(model, with(GetParam()));
  simulator.advance(500);
  simulator.setPush({Vector3d(1, 0, 0), Vector3d::Zero()});  // friction holds up to m g = 7 N
  simulator.advance(500);
  EXPECT_NEAR(simulator.groundLoad().force.x(), -1, 2e-2);
  EXPECT_NEAR(simulator.groundLoad().force.z(), model.mass * 9.8, 2e-2);
}

INSTANTIATE_TEST_SUITE_P(Bodies, OutsideLoads,
                         testing::Values(Multibody::kFolded, Multibody::kHinged),
                         [](const auto& info) {
                           return info.param == Multibody::kFolded ? "folded" : "hinged";
                         });

TEST(Links, AreThoseOfTheUrdf) {
  const VehicleModel model = hummingbird();
  double mass = 0;
  for (const LinkModel& link : model.links) {
    mass += link.mass;
    EXPECT_EQ(link.joint.empty(), link.name == model.base_link) << link.name;
    EXPECT_EQ(link.on_base, link.name.find("rotor_") == std::string::npos) << link.name;
  }
  EXPECT_NEAR(mass, 0.73103, 1e-12);
}

}  // namespace
}  // namespace quad_sim
