// Sensors: noise of the right size, the same whoever asks and when; what an IMU feels.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "hummingbird.hpp"
#include "quad_sim/imu_sensor.hpp"
#include "quad_sim/odometry_sensor.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using Tags = std::map<std::string, std::string>;

SensorModel sensor(const Tags& tags) {
  SensorModel model;
  model.declaration = {"plugin.so", "sensor", "file.urdf:1", tags};
  return model;
}

OdometrySensor odometrySensor(const Tags& tags, std::uint64_t seed = 1, bool compat = false) {
  return OdometrySensor(sensor(tags), "bee/odometry", seed, 0.001, compat);
}

const Tags kNoisy = {{"noiseNormalPosition", "0.01 0.02 0.03"},
                     {"noiseUniformPosition", "0.3 0 0"},
                     {"noiseNormalQuaternion", "0.02 0.02 0.02"},
                     {"noiseNormalLinearVelocity", "0.1 0.1 0.1"},
                     {"noiseUniformAngularVelocity", "0 0 0.6"}};

TEST(OdometrySensor, NoiseHasTheSizeOfItsTags) {
  const OdometrySensor s = odometrySensor(kNoisy);
  constexpr int kReadings = 20000;
  Vector3d position = Vector3d::Zero(), velocity = position, rate = position, angle = position;
  double widest = 0;
  for (int k = 0; k < kReadings; ++k) {
    const Odometry o = s.sense(Odometry(), k);
    position += o.p_WB.cwiseAbs2() / kReadings;
    velocity += o.v_WB_B.cwiseAbs2() / kReadings;
    rate += o.w_WB_B.cwiseAbs2() / kReadings;
    angle += (2 * o.q_WB.vec()).cwiseAbs2() / kReadings;
    widest = std::max(widest, std::abs(o.w_WB_B.z()));
  }
  // The variance of n normal numbers is known to sqrt(2 / n), that is 1 %; five of that.
  const auto expect = [](double got, double sigma) {
    EXPECT_NEAR(got, sigma * sigma, 0.05 * sigma * sigma);
  };
  expect(position.x(), std::sqrt(0.01 * 0.01 + 0.3 * 0.3 / 3));
  expect(position.y(), 0.02);
  expect(angle.x(), 0.02);
  expect(velocity.z(), 0.1);
  expect(rate.z(), 0.6 / std::sqrt(3));
  EXPECT_EQ(rate.x(), 0);
  EXPECT_LE(widest, 0.6);
}

TEST(OdometrySensor, VarianceCountsTheUniformPartToo) {
  EXPECT_NEAR(odometrySensor(kNoisy).poseVariance()[0], 0.0001 + 0.03, 1e-15);
  EXPECT_NEAR(odometrySensor(kNoisy).twistVariance()[5], 0.12, 1e-15);
  EXPECT_NEAR(odometrySensor(kNoisy, 1, true).poseVariance()[0], 0.0001, 1e-15)
      << "RotorS leaves it out";
}

TEST(OdometrySensor, NoiseBelongsToTheStepTheSensorAndTheSeed) {
  const OdometrySensor s = odometrySensor(kNoisy), twin = odometrySensor(kNoisy);
  std::vector<Odometry> forwards;
  for (int k = 0; k < 100; ++k) forwards.push_back(s.sense(Odometry(), k));
  for (int k = 99; k >= 0; k -= 7) {  // another rate, another order
    EXPECT_EQ(twin.sense(Odometry(), k).p_WB, forwards[static_cast<std::size_t>(k)].p_WB);
  }
  EXPECT_NE(odometrySensor(kNoisy, 2).sense(Odometry(), 5).p_WB, forwards[5].p_WB);
  const OdometrySensor other(sensor(kNoisy), "wasp/odometry", 1, 0.001, false);
  EXPECT_NE(other.sense(Odometry(), 5).p_WB, forwards[5].p_WB);
  Tags own_seed = kNoisy;
  own_seed["randomEngineSeed"] = "1";
  EXPECT_EQ(odometrySensor(own_seed, 77).sense(Odometry(), 5).p_WB, forwards[5].p_WB);
}

TEST(OdometrySensor, WithoutNoiseItIsTheTruth) {
  Odometry truth;
  truth.p_WB = Vector3d(0.1, 0.2, 0.3);
  truth.q_WB = Eigen::Quaterniond(0.6, 0.8, 1e-17, 0);
  EXPECT_EQ(odometrySensor({}).sense(truth, 3).q_WB.coeffs(), truth.q_WB.coeffs());
  EXPECT_FALSE(odometrySensor({}).scheduled());
}

TEST(OdometrySensor, BadTagsAreErrorsThatNameThem) {
  const auto says = [](const Tags& tags) {
    return complaint<quad_support::ConfigError>([&] { odometrySensor(tags); });
  };
  EXPECT_THAT(says({{"noiseNormalPosition", "1 2"}}),
              HasSubstr("noiseNormalPosition = 1 2 must be three finite numbers >= 0"));
  EXPECT_THAT(says({{"noiseUniformPosition", "1 2 -3"}}), HasSubstr("noiseUniformPosition"));
  EXPECT_THAT(says({{"noiseUniformPosition", "1 2 x"}}), HasSubstr("must be three numbers"));
  EXPECT_THAT(says({{"measurementDivisor", "0"}}),
              HasSubstr("measurementDivisor = 0 must be a whole number of cycles, 1 to"));
  EXPECT_THAT(says({{"measurementDelay", "1.5"}}), HasSubstr("measurementDelay"));
  EXPECT_THAT(says({{"unknownDelay", "-1"}}), HasSubstr("unknownDelay = -1 must be >= 0"));
  EXPECT_THAT(says({{"randomEngineSeed", "-1"}}), HasSubstr("randomEngineSeed"));
  EXPECT_THAT(says({{"parentFrameId", "moon"}}), HasSubstr("parentFrameId = moon must be world"));
}

TEST(OdometryDelay, DividesAndDelaysInCyclesOfTenMilliseconds) {
  const OdometrySensor s = odometrySensor({{"measurementDivisor", "3"}, {"measurementDelay", "4"}});
  EXPECT_EQ(s.period(), 30);
  EXPECT_EQ(s.delay(), 40);
  OdometryDelay delay(s);
  std::vector<std::pair<std::int64_t, std::int64_t>> out;  // step of delivery, of the sample
  for (std::int64_t step = 0; step <= 130; step = delay.nextEvent(step)) {
    Odometry truth;
    truth.time_ns = step;
    if (const auto o = delay.at(step, truth)) out.emplace_back(step, o->time_ns);
  }
  EXPECT_EQ(out, (std::vector<std::pair<std::int64_t, std::int64_t>>{
                     {40, 0}, {70, 30}, {100, 60}, {130, 90}}));
}

TEST(OdometryDelay, SamplesOnTheirWayAreSavedWithTheState) {
  Tags tags = kNoisy;
  tags["measurementDelay"] = "3";
  const OdometrySensor s = odometrySensor(tags);
  OdometryDelay through(s), fresh(s);
  for (std::int64_t step = 0; step <= 50; step += 10) through.at(step, Odometry());
  StateArchive out;
  through.archive(out);
  StateArchive in(out.numbers());
  fresh.archive(in);
  for (std::int64_t step = 60; step <= 90; step += 10) {
    EXPECT_EQ(through.at(step, Odometry())->p_WB, fresh.at(step, Odometry())->p_WB);
  }
}

TEST(OdometryDelay, UnknownDelayMovesTheStamp) {
  EXPECT_EQ(odometrySensor({{"unknownDelay", "1.25"}}).extraStamp(), 1250000000);
  EXPECT_EQ(odometrySensor({{"unknownDelay", "1.25"}}, 1, true).extraStamp(), 1000000000)
      << "RotorS cuts it";
}

// ---- IMU ----

const Tags kImu = {
    {"gyroscopeNoiseDensity", "0.01"},          {"gyroscopeBiasRandomWalk", "0.02"},
    {"gyroscopeBiasCorrelationTime", "50"},     {"gyroscopeTurnOnBiasSigma", "0.5"},
    {"accelerometerNoiseDensity", "0.04"},      {"accelerometerRandomWalk", "0.01"},
    {"accelerometerBiasCorrelationTime", "20"}, {"accelerometerTurnOnBiasSigma", "0.2"}};

ImuSensor imuSensor(const Tags& tags, std::uint64_t seed = 1, bool compat = false) {
  return ImuSensor(sensor(tags), "bee/imu", seed, 0.001, compat);
}

/// Allan variance of samples a period apart for clusters of m, overlapping.
double allanVariance(const std::vector<double>& x, std::size_t m) {
  std::vector<double> sum(x.size() + 1, 0.0);
  std::partial_sum(x.begin(), x.end(), sum.begin() + 1);
  const auto mean = [&](std::size_t i) { return (sum[i + m] - sum[i]) / static_cast<double>(m); };
  double total = 0;
  const std::size_t n = x.size() - 2 * m + 1;
  for (std::size_t i = 0; i < n; ++i) total += std::pow(mean(i + m) - mean(i), 2);
  return total / (2.0 * static_cast<double>(n));
}

/// Of white noise of density N and a Gauss-Markov process driven by density K with time constant T
/// (IEEE Std 952, annex C).
double expectedAllanVariance(double N, double K, double T, double tau) {
  const double e = std::exp(-tau / T);
  return N * N / tau + std::pow(K * T, 2) / tau * (1 - T / (2 * tau) * (3 - 4 * e + e * e));
}

TEST(ImuSensor, AllanVarianceIsThatOfItsTags) {
  constexpr std::size_t kSamples = 400000;  // 4000 s at 100 Hz
  ImuSensor imu = imuSensor(kImu);
  std::vector<std::vector<double>> gyro(3), accelerometer(3);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const ImuReading r = imu.sense(ImuReading(), static_cast<std::int64_t>(10 * k));
    for (int axis = 0; axis < 3; ++axis) {
      gyro[static_cast<std::size_t>(axis)].push_back(r.rate_S[axis]);
      accelerometer[static_cast<std::size_t>(axis)].push_back(r.specific_force_S[axis]);
    }
  }
  for (const std::size_t m :
       {1UL, 10UL, 100UL, 1000UL, 10000UL}) {  // 10 ms, white, to 100 s, beyond the bias's memory
    const double tau = 0.01 * static_cast<double>(m);
    double g = 0, a = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      g += allanVariance(gyro[axis], m) / 3;
      a += allanVariance(accelerometer[axis], m) / 3;
    }
    // n clusters know the variance to sqrt(2/n), three axes to a sqrt(3) of that; four sigma, and
    // where clusters are few neighbouring ones are correlated: half as many count. Below 1000 s /
    // tau the floor of 1 % is the start of the bias at 0.
    const double clusters = 3 * static_cast<double>(kSamples / m) / 2;
    const double tolerance = 4 * std::sqrt(2 / clusters) + 0.01;
    const double expected_g = expectedAllanVariance(0.01, 0.02, 50, tau),
                 expected_a = expectedAllanVariance(0.04, 0.01, 20, tau);
    EXPECT_NEAR(g / expected_g, 1, tolerance) << "gyroscope, tau = " << tau;
    EXPECT_NEAR(a / expected_a, 1, tolerance) << "accelerometer, tau = " << tau;
  }
}

TEST(ImuSensor, TurnOnBiasIsDrawnOncePerSeed) {
  Tags only_bias = {{"gyroscopeNoiseDensity", "0"},
                    {"gyroscopeBiasRandomWalk", "0"},
                    {"gyroscopeTurnOnBiasSigma", "0.5"}};
  double sum = 0;
  constexpr int kSeeds = 1000;
  for (int seed = 0; seed < kSeeds; ++seed) {
    ImuSensor imu = imuSensor(only_bias, static_cast<std::uint64_t>(seed));
    const Vector3d first = imu.sense(ImuReading(), 0).rate_S;
    EXPECT_EQ(imu.sense(ImuReading(), 12345).rate_S, first);
    sum += first.squaredNorm();
  }
  // 3000 numbers know their variance to sqrt(2/3000) = 2.6 %; four of that.
  EXPECT_NEAR(sum / (3 * kSeeds), 0.25, 0.25 * 0.104);
}

TEST(ImuSensor, ReadingsDoNotDependOnRateOrOrder) {
  ImuSensor always = imuSensor(kImu), seldom = imuSensor(kImu);
  std::vector<ImuReading> all;
  for (int k = 0; k < 200; ++k) all.push_back(always.sense(ImuReading(), 10 * k));
  for (const int k : {3, 50, 199, 20, 0}) {
    EXPECT_EQ(seldom.sense(ImuReading(), 10 * k).rate_S, all[static_cast<std::size_t>(k)].rate_S)
        << k;
    EXPECT_EQ(seldom.sense(ImuReading(), 10 * k + 9).specific_force_S,
              all[static_cast<std::size_t>(k)].specific_force_S)
        << "same sample";
  }
}

TEST(ImuSensor, VarianceIsThatOfASampleAndInRotorsOfTheDensity) {
  EXPECT_NEAR(imuSensor(kImu).rateVariance(), 0.01 * 0.01 / 0.01, 1e-15);
  EXPECT_NEAR(imuSensor(kImu, 1, true).rateVariance(), 0.01 * 0.01, 1e-15);
  Tags fast = kImu;
  fast["updateRate"] = "1000";
  EXPECT_NEAR(imuSensor(fast).rateVariance(), 0.01 * 0.01 / 0.001, 1e-15);
}

TEST(ImuSensor, RotorsModelsWriteATagItsPluginDoesNotRead) {
  const Tags tags = {{"gyroscopeRandomWalk", "0"}};
  EXPECT_EQ(readInertialNoise(sensor(tags).declaration, "gyroscope", false).random_walk, 0);
  EXPECT_EQ(readInertialNoise(sensor(tags).declaration, "gyroscope", true).random_walk, 3.8785e-05);
}

TEST(ImuSensor, BadTagsAreErrorsThatNameThem) {
  const auto says = [](const Tags& tags) {
    return complaint<quad_support::ConfigError>([&] { imuSensor(tags); });
  };
  EXPECT_THAT(says({{"gyroscopeNoiseDensity", "-1"}}),
              HasSubstr("gyroscopeNoiseDensity = -1 must be >= 0"));
  EXPECT_THAT(says({{"accelerometerBiasCorrelationTime", "0"}}),
              HasSubstr("accelerometerBiasCorrelationTime = 0 must be > 0 s"));
  EXPECT_THAT(says({{"updateRate", "0"}}), HasSubstr("updateRate = 0 must be > 0 Hz"));
}

const SensorModel& imuOf(const VehicleModel& model) {
  for (const SensorModel& s : model.sensors) {
    if (s.kind == SensorModel::Kind::kImu) return s;
  }
  throw std::logic_error("the vehicle has no IMU");
}

TEST(Imu, FeelsGravityAtRestAndNothingInFreeFall) {
  const VehicleModel m = hummingbird();
  Simulator s(m, SimulatorOptions());
  s.advance(500);  // on the ground
  EXPECT_NEAR((s.imu(imuOf(m)).specific_force_S - Vector3d(0, 0, 9.8)).norm(), 0, 1e-6);
  SimulatorOptions air;
  air.ground = false;
  Simulator falling(m, air);
  falling.advance(10);  // rotors stand still, and at 0.1 m/s nothing drags
  EXPECT_NEAR(falling.imu(imuOf(m)).specific_force_S.norm(), 0, 1e-9);
}

TEST(Imu, FeelsTheArmOfATurn) {
  VehicleModel m = hummingbird();
  SensorModel far = imuOf(m);
  far.X_BS.translation() = m.com_B + Vector3d(0.5, 0, 0);
  SimulatorOptions options;
  options.ground = false;
  options.gravity = 0;
  Simulator s(m, options);
  VehicleState spin;
  spin.w_WB_B = Vector3d(0, 0, 4);
  spin.rotor_speed.assign(4, 0.0);
  s.setStartState(spin);
  s.advance(100);
  // w² r = 8 m/s² towards the centre; the mean over a step of 1 ms lies half a step, 2 mrad,
  // behind: 0.016 m/s² sideways.
  const Vector3d f = s.imu(far).specific_force_S;
  EXPECT_NEAR(f.x(), -8, 1e-4);
  EXPECT_NEAR(f.y(), 0, 0.017);
  EXPECT_NEAR(s.imu(far).rate_S.z(), 4, 1e-9);
}

}  // namespace
}  // namespace quad_sim
