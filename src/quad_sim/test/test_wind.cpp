// Wind: impulses by hand, drag through moving air, and the turbulence's variance, correlation and
// spectrum against Dryden's formulas.
#include <gmock/gmock.h>

#include <cmath>
#include <complex>

#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using quad_support::ConfigError;
using testing::HasSubstr;

std::string windy(const std::string& tags) {
  return replaced(
      hummingbirdText(), "</robot>",
      "<gazebo><plugin name=\"wind_plugin\" filename=\"librotors_gazebo_wind_plugin.so\">"
      "<frameId>world</frameId><linkName>hummingbird/base_link</"
      "linkName><robotNamespace>hummingbird</robotNamespace>" +
          tags + "</plugin></gazebo></robot>");
}

VehicleModel model(const std::string& tags) { return parseVehicle(windy(tags), "m.urdf"); }

SimulatorOptions options(double step = 0.001, std::uint64_t seed = 1) {
  SimulatorOptions o;
  o.step = step;
  o.ground = false;
  o.seed = seed;
  return o;
}

VehicleState freeFall(const VehicleModel& m) {
  VehicleState start;
  start.rotor_speed.assign(m.rotors.size(), 0.0);
  return start;
}

TEST(Wind, AConstantForceAcceleratesAndTurns) {
  const VehicleModel m = model(
      "<windDirection>0 2 0</windDirection><windForceMean>0.4</windForceMean>"
      "<xyzOffset>0 0 0.1</xyzOffset>");
  Simulator s(m, options());
  s.setStartState(freeFall(m));
  s.advance(1);
  const VehicleState end = s.state();
  EXPECT_NEAR((end.v_WB + end.q_WB * end.w_WB_B.cross(m.com_B)).y(), 0.4 / m.mass * 0.001, 1e-15);
  EXPECT_NEAR(s.state().w_WB_B.x(), -0.4 * (0.1 - m.com_B.z()) / m.inertia_B(0, 0) * 0.001, 1e-12);
  EXPECT_EQ(s.outsideForce(), Vector3d(0, 0.4, 0));
  EXPECT_EQ(s.wind(), Vector3d::Zero());
}

TEST(Wind, AGustHasItsImpulseWhateverTheStep) {
  // 5 N along (1, 1, 0) from 0.4 s for 0.1237 s, which is no whole number of steps.
  const VehicleModel m = model(
      "<windGustDirection>1 1 0</windGustDirection><windGustForceMean>5</windGustForceMean>"
      "<windGustStart>0.4</windGustStart><windGustDuration>0.1237</windGustDuration>");
  for (const double step : {0.0001, 0.001, 0.01, 0.02}) {
    SCOPED_TRACE(step);
    Simulator s(m, options(step));
    s.setStartState(freeFall(m));
    const int before = static_cast<int>(std::lround(0.4 / step)),
              rest = static_cast<int>(std::lround(0.2 / step));
    s.advance(before);
    EXPECT_EQ(s.state().v_WB.x(), 0) << "not yet";
    s.advance(rest);
    EXPECT_EQ(s.outsideForce(), Vector3d::Zero()) << "over";
    // At the centre of mass it is exactly the impulse over the mass; at base_link the turning adds.
    // Rounding of up to 2000 steps.
    const VehicleState end = s.state();
    const Vector3d v_C = end.v_WB + end.q_WB * end.w_WB_B.cross(m.com_B);
    EXPECT_NEAR(v_C.x(), 5 / std::sqrt(2.0) * 0.1237 / m.mass, 1e-11);
    EXPECT_NEAR(v_C.y(), v_C.x(), 1e-12);
  }
}

TEST(Wind, SinusoidsOfForceAndSpeed) {
  const VehicleModel m = model(
      "<windForceAmplitude>2</windForceAmplitude><windFrequency>0.5</windFrequency>"
      "<windPhase>0.3</windPhase><windSpeedMean>1</windSpeedMean><windSpeedAmplitude>3</"
      "windSpeedAmplitude>");
  Simulator s(m, options());
  s.setStartState(freeFall(m));
  for (const int n : {1, 250, 1000}) {
    s.advance(n);
    const double sine =
        std::sin(2 * M_PI * 0.5 * (static_cast<double>(s.stepCount() - 1) * 0.001) + 0.3);
    EXPECT_NEAR(s.outsideForce().x(), 2 * sine, 1e-12);
    EXPECT_NEAR(s.wind().x(), 1 + 3 * sine, 1e-12);
  }
}

TEST(Wind, MovingAirDragsTheRotorsAlong) {
  // In a wind of u the hovering vehicle is pushed as if it moved with -u: 4 |w| c u.
  const VehicleModel m =
      model("<windSpeedMean>2</windSpeedMean><windDirection>1 0 0</windDirection>");
  Simulator s(m, options(1e-4));
  s.setStartState(equilibrium(m, 9.8, 10));
  s.advance(1);
  const double push = 4 * hoverSpeed(m, 9.8) * 8.06428e-05 * 2;
  const VehicleState end = s.state();
  EXPECT_NEAR((end.v_WB + end.q_WB * end.w_WB_B.cross(m.com_B)).x(), push / m.mass * 1e-4, 1e-12);
  EXPECT_EQ(s.wind(), Vector3d(2, 0, 0));
}

/// n samples of the air's velocity, one a step.
std::vector<Vector3d> air(const VehicleModel& m, const SimulatorOptions& o, int n) {
  Simulator s(m, o);
  s.setStartState(freeFall(m));
  std::vector<Vector3d> samples;
  for (int i = 0; i < n; ++i) {
    s.advance(1);
    samples.push_back(s.wind());
    if (i % 200 == 199)
      s.setState(
          freeFall(m));  // or it falls for ever; the air starts afresh, which keeps it stationary
  }
  return samples;
}

const char* const kDryden =
    "<turbulenceIntensity>1.5 1 0.7</turbulenceIntensity><turbulenceLength>4 3 2</turbulenceLength>"
    "<turbulenceSpeed>10</turbulenceSpeed>";

TEST(Turbulence, VarianceAndCorrelationAreDrydens) {
  const VehicleModel m = model(kDryden);
  const double sigma[] = {1.5, 1, 0.7}, T[] = {0.4, 0.3, 0.2};
  // 40 000 flights of 0.1 s would be independent; here 4000 stretches of 200 steps of 20 ms, 4 s,
  // ten time constants each.
  const double step = 0.02;
  constexpr int kStretch = 200, kStretches = 1000, kLag = 10;
  const std::vector<Vector3d> samples = air(m, options(step), kStretch * kStretches);
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    double variance = 0, product = 0, mean = 0;
    int products = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      mean += samples[i][axis];
      variance += samples[i][axis] * samples[i][axis];
      if (i % kStretch + kLag >= kStretch) continue;
      product += samples[i][axis] * samples[i + kLag][axis];
      ++products;
    }
    const double n = static_cast<double>(samples.size());
    // About T/h = 20 samples say one thing: 10 000 independent ones, so a standard error of 1.4 %
    // of the variance. Three of them.
    const double tolerance = 3 * 0.014 * sigma[axis] * sigma[axis];
    EXPECT_NEAR(mean / n, 0, 3 * 0.01 * sigma[axis]);
    EXPECT_NEAR(variance / n, sigma[axis] * sigma[axis], tolerance);
    // Dryden's correlation functions: exp(-t/T) along, (1 - t/(2T)) exp(-t/T) across.
    const double r = kLag * step / T[axis];
    const double correlation = std::exp(-r) * (axis == 0 ? 1 : 1 - r / 2);
    EXPECT_NEAR(product / products, sigma[axis] * sigma[axis] * correlation, tolerance);
  }
}

TEST(Turbulence, SpectrumIsDrydens) {
  // Periodograms of 400 independent stretches, averaged, at a few frequencies; the first of a
  // stretch is drawn stationary.
  const VehicleModel m = model(kDryden);
  const double step = 0.02, sigma[] = {1.5, 1, 0.7}, T[] = {0.4, 0.3, 0.2};
  constexpr int kStretch = 200, kStretches = 1000;
  const std::vector<Vector3d> samples = air(m, options(step, 5), kStretch * kStretches);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int line : {1, 2, 4, 8, 12}) {
      SCOPED_TRACE(testing::Message() << "axis " << axis << " line " << line);
      const double w = 2 * M_PI * line / (kStretch * step);
      double measured = 0, expected = 0;
      for (int s = 0; s < kStretches; ++s) {
        std::complex<double> sum = 0;
        for (int i = 0; i < kStretch; ++i) {
          sum += samples[static_cast<std::size_t>(s * kStretch + i)][axis] *
                 std::polar(1.0, -w * step * i);
        }
        measured += std::norm(sum) / kStretches;
      }
      // What the periodogram of a sampled stretch must be, exactly: the sum of the correlation
      // function over all pairs.
      for (int lag = 1 - kStretch; lag < kStretch; ++lag) {
        const double r = std::abs(lag) * step / T[axis];
        const double correlation = std::exp(-r) * (axis == 0 ? 1 : 1 - r / 2);
        expected += (kStretch - std::abs(lag)) * sigma[axis] * sigma[axis] * correlation *
                    std::cos(w * step * lag);
      }
      // 1000 exponentially distributed values: a standard error of 3.2 %. Three and a half of them,
      // for fifteen lines.
      EXPECT_NEAR(measured, expected, 3.5 * 0.032 * expected);
      // And the formula of the docs, one-sided in w, where the stretch is long and the sampling
      // fine against T.
      const double x = T[axis] * w,
                   spectrum =
                       sigma[axis] * sigma[axis] * T[axis] / M_PI *
                       (axis == 0 ? 2 / (1 + x * x) : (1 + 3 * x * x) / std::pow(1 + x * x, 2));
      EXPECT_NEAR(measured * step / (M_PI * kStretch), spectrum, 0.2 * spectrum);
    }
  }
}

TEST(Turbulence, IsThatOfTheSeedAndTheSameAfterReset) {
  const VehicleModel m = model(kDryden);
  const auto first = air(m, options(0.001, 1), 50), again = air(m, options(0.001, 1), 50),
             other = air(m, options(0.001, 2), 50);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
  Simulator s(m, options());
  s.setStartState(equilibrium(m, 9.8, 10));
  s.advance(300);
  const VehicleState end = s.state();
  const SavedState saved = s.save();
  s.reset();
  s.advance(300);
  EXPECT_EQ(s.state().p_WB, end.p_WB);
  EXPECT_EQ(s.save().numbers, saved.numbers);
}

TEST(Turbulence, TheFineStepIsTheExactFilterToo) {
  // r = h/T below the switch to series: 1000 samples 1 ms apart, T = 2 s. The variance of
  // increments is 2 sigma² (1 - rho).
  const VehicleModel m = model(
      "<turbulenceIntensity>1 1 1</turbulenceIntensity><turbulenceLength>20 20 "
      "20</turbulenceLength>"
      "<turbulenceSpeed>10</turbulenceSpeed>");
  Simulator s(m, options());
  s.setStartState(freeFall(m));
  Vector3d sum = Vector3d::Zero(), before = Vector3d::Zero();
  constexpr int kSamples = 4000;
  for (int i = 0; i <= kSamples; ++i) {
    s.advance(1);
    if (i > 0) sum += (s.wind() - before).cwiseAbs2();
    before = s.wind();
  }
  const double r = 0.001 / 2;
  // 4000 nearly independent increments: 2.2 % standard error, three of them.
  EXPECT_NEAR(sum.x() / kSamples, 2 * -std::expm1(-r), 3 * 0.022 * 2 * r);
  const double across = 2 * (1 - (1 - r / 2) * std::exp(-r));
  EXPECT_NEAR(sum.y() / kSamples, across, 3 * 0.022 * across);
  EXPECT_NEAR(sum.z() / kSamples, across, 3 * 0.022 * across);
}

TEST(Wind, BadSettingsAreNamed) {
  const auto says = [](const std::string& tags) {
    return complaint<ConfigError>([&] { Simulator(model(tags), options()); });
  };
  EXPECT_THAT(says("<windDirection>0 0 0</windDirection>"),
              HasSubstr("windDirection = 0 0 0 must point somewhere"));
  EXPECT_THAT(says("<windDirection>1 0</windDirection>"), HasSubstr("must be three numbers"));
  EXPECT_THAT(says("<windGustDuration>-1</windGustDuration>"),
              HasSubstr("windGustDuration = -1 must be >= 0"));
  EXPECT_THAT(says("<windForceMean>strong</windForceMean>"), HasSubstr("must be a number"));
  EXPECT_THAT(says("<useCustomStaticWindField>true</useCustomStaticWindField>"),
              HasSubstr("must be false"));
  EXPECT_THAT(says("<turbulenceIntensity>1 1 1</turbulenceIntensity>"),
              HasSubstr("turbulenceLength is missing"));
  EXPECT_THAT(says("<turbulenceIntensity>1 1 1</turbulenceIntensity><turbulenceLength>1 1 "
                   "1</turbulenceLength>"),
              HasSubstr("turbulenceSpeed must be > 0"));
}

}  // namespace
}  // namespace quad_sim
