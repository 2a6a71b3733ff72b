// The simulator against Newton and Euler (newton_euler_reference.hpp): thesis Eqs. (1.1), (1.2),
// (1.4), with rotor lag, H-force and rolling moment. Judged by the order of convergence, and
// against what a plain first-order method errs.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "newton_euler_reference.hpp"
#include "quad_sim/simulation_config.hpp"

namespace {

using Eigen::Vector3d;
using reference::Method;
using reference::Speeds;
using reference::State;

using quad_sim::Multibody;

struct Scenario {
  std::string name;
  double duration;  ///< [s]
  State start;
  reference::Command command;
  Multibody multibody = Multibody::kFolded;
};

void PrintTo(const Scenario& s, std::ostream* out) { *out << s.name; }

State hovering() {
  State s;
  s.p.z() = 100;
  s.rotor.fill(reference::hoverSpeed());
  return s;
}

/// Hover for 0.1 s, then `offset` [rad/s] added to each rotor's command.
reference::Command stepBy(const Speeds& offset) {
  return [offset](double t) {
    Speeds u;
    for (std::size_t i = 0; i < 4; ++i) u[i] = reference::hoverSpeed() + (t > 0.1 ? offset[i] : 0);
    return u;
  };
}

std::vector<Scenario> scenarios() {
  const auto constant = [](double value) {
    return [value](double) { return Speeds{value, value, value, value}; };
  };
  std::vector<Scenario> all;
  State s;
  s.v = Vector3d(1, 0, 2);
  all.push_back({"FreeFall", 2, s, constant(0)});
  all.push_back({"Hover", 20, hovering(), stepBy({0, 0, 0, 0})});
  all.push_back({"ThrustStep", 2, hovering(), stepBy({30, 30, 30, 30})});
  all.push_back({"RollStep", 0.6, hovering(), stepBy({0, 10, 0, -10})});
  all.push_back({"PitchStep", 0.6, hovering(), stepBy({-10, 0, 10, 0})});
  all.push_back({"YawStep", 2, hovering(), stepBy({-30, 30, -30, 30})});
  s = hovering();
  s.v = Vector3d(8, -5, 1);
  all.push_back({"TranslationWithDrag", 2, s, stepBy({0, 0, 0, 0})});
  all.push_back({"Asymmetric", 0.6, hovering(), stepBy({25, -12, 7, 3})});
  all.push_back({"MotorLag", 0.5, State{}, constant(600)});
  all.push_back({"Saturation", 1, hovering(), constant(1200)});
  s = hovering();
  s.w = Vector3d(0.2, -0.1, 0.3);
  all.push_back({"MotorCut", 1.5, s, [](double t) {
                   const double w = t > 0.1 ? 0 : reference::hoverSpeed();
                   return Speeds{w, w, w, w};
                 }});
  s = hovering();
  s.w = Vector3d(6, 8, -4);
  s.q = Eigen::Quaterniond(0.8, 0.36, -0.48, 0);
  all.push_back({"Tumbling", 1, s, stepBy({40, -20, 10, 0})});
  return all;
}

/// The same flights with the rotors as bodies of their own.
std::vector<Scenario> hinged() {
  std::vector<Scenario> all = scenarios();
  for (Scenario& s : all) s.multibody = Multibody::kHinged;
  return all;
}

State simulate(const Scenario& scenario, int steps_per_10ms) {
  const quad_sim::VehicleModel model =
      quad_sim::loadVehicle(quad_sim::findUrdf("hummingbird.urdf", ""));
  quad_sim::SimulatorOptions options;
  options.step = 0.01 / steps_per_10ms;
  options.ground = false;
  options.multibody = scenario.multibody;
  quad_sim::Simulator simulator(model, options);
  quad_sim::VehicleState start;
  start.p_WB = scenario.start.p;
  start.v_WB = scenario.start.v;
  start.q_WB = scenario.start.q;
  start.w_WB_B = scenario.start.w;
  start.rotor_speed.assign(scenario.start.rotor.begin(), scenario.start.rotor.end());
  simulator.setStartState(start);
  const long intervals = std::lround(scenario.duration / 0.01);
  for (long k = 0; k < intervals; ++k) {
    const Speeds u = scenario.command((static_cast<double>(k) + 0.5) * 0.01);
    simulator.setCommand({u.begin(), u.end()});
    simulator.advance(steps_per_10ms);
  }
  const quad_sim::VehicleState end = simulator.state();
  State out{end.p_WB, end.v_WB, end.q_WB, end.w_WB_B, {}};
  std::copy(end.rotor_speed.begin(), end.rotor_speed.end(), out.rotor.begin());
  return out;
}

class NewtonEuler : public testing::TestWithParam<Scenario> {};

TEST_P(NewtonEuler, ErrorShrinksWithTheStepAndIsSmall) {
  const Scenario& scenario = GetParam();
  const State truth = reference::integrate(scenario.start, scenario.command, scenario.duration,
                                           1e-4, Method::kRungeKutta4);
  const State check = reference::integrate(scenario.start, scenario.command, scenario.duration,
                                           2e-4, Method::kRungeKutta4);
  const State euler = reference::integrate(scenario.start, scenario.command, scenario.duration,
                                           1e-3, Method::kSemiImplicitEuler);
  // Halving the reference's step must not change it by more than it is trusted: its error is a
  // fifteenth of that.
  constexpr double kTrusted = 1e-9;
  ASSERT_LT(distance(truth, check), kTrusted);

  const double coarse = distance(simulate(scenario, 5), truth);  // 2 ms
  const double fine = distance(simulate(scenario, 10), truth);   // 1 ms
  const double first_order = distance(euler, truth);
  RecordProperty("error_1ms", std::to_string(fine));
  std::printf(
      "%-20s error at 2 ms %.2e, at 1 ms %.2e (ratio %.2f); semi-implicit Euler at 1 ms %.2e\n",
      scenario.name.c_str(), coarse, fine, coarse / fine, first_order);
  // First order would be a ratio of 2; 1.9 leaves room for the next order. Below kTrusted there is
  // nothing to compare.
  if (fine > kTrusted) {
    EXPECT_GE(coarse / fine, 1.9);
    EXPECT_LE(fine, 2 * first_order);
  }
}

TEST_P(NewtonEuler, FoldedAndHingedAgree) {
  Scenario scenario = GetParam();
  const State euler = reference::integrate(scenario.start, scenario.command, scenario.duration,
                                           1e-3, Method::kSemiImplicitEuler);
  const State truth = reference::integrate(scenario.start, scenario.command, scenario.duration,
                                           1e-4, Method::kRungeKutta4);
  scenario.multibody = Multibody::kFolded;
  const State folded = simulate(scenario, 10);
  scenario.multibody = Multibody::kHinged;
  const State hinged = simulate(scenario, 10);
  // Within what an honest first-order method may be off, twice; 1e-9 is what the reference is
  // trusted for.
  EXPECT_LE(distance(folded, hinged), std::max(2 * distance(euler, truth), 1e-9));
}

INSTANTIATE_TEST_SUITE_P(Flights, NewtonEuler, testing::ValuesIn(scenarios()),
                         [](const testing::TestParamInfo<Scenario>& info) {
                           return info.param.name;
                         });

INSTANTIATE_TEST_SUITE_P(Hinged, NewtonEuler, testing::ValuesIn(hinged()),
                         [](const testing::TestParamInfo<Scenario>& info) {
                           return info.param.name;
                         });

TEST(NewtonEulerReference, TheFlightsDoSomething) {
  // A scenario that stays at its start would pass whatever the simulator does.
  for (const Scenario& scenario : scenarios()) {
    if (scenario.name == "Hover") continue;
    const State end = reference::integrate(scenario.start, scenario.command, scenario.duration,
                                           1e-3, Method::kRungeKutta4);
    EXPECT_GT(distance(end, scenario.start), 0.05) << scenario.name;
  }
}

}  // namespace
