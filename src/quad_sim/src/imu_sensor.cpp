#include "quad_sim/imu_sensor.hpp"

#include <cmath>

#include "quad_sim/odometry_sensor.hpp"

namespace quad_sim {

using Eigen::Vector3d;

namespace {

// Draws of one sample: biases 0 to 5, white noise 6 to 11; turn-on biases of their own, at a step
// no sample has.
constexpr int kGyroscope = 0, kAccelerometer = 3, kWhite = 6;
constexpr std::uint64_t kTurnOn = ~std::uint64_t{0};

}  // namespace

InertialNoise readInertialNoise(const PluginDeclaration& p, const std::string& prefix,
                                bool compat) {
  const bool gyro = prefix == "gyroscope";
  InertialNoise n;  // defaults: ADIS16448, as in RotorS
  n.density = nonNegative(p, prefix + "NoiseDensity", gyro ? 0.0003394 : 0.004);
  const std::string walk = gyro ? "gyroscopeBiasRandomWalk" : "accelerometerRandomWalk";
  n.random_walk = nonNegative(p, walk, gyro ? 3.8785e-05 : 0.006);
  // RotorS's models write gyroscopeRandomWalk, its plugin never reads it.
  if (gyro && !compat && p.tags.count(walk) == 0)
    n.random_walk = nonNegative(p, "gyroscopeRandomWalk", n.random_walk);
  n.correlation_time = p.number(prefix + "BiasCorrelationTime", gyro ? 1000 : 300);
  if (!(n.correlation_time > 0)) p.fail(prefix + "BiasCorrelationTime", "must be > 0 s");
  n.turn_on_sigma = nonNegative(p, prefix + "TurnOnBiasSigma", gyro ? 0.0087 : 0.196);
  return n;
}

ImuSensor::ImuSensor(const SensorModel& model, const std::string& identity, std::uint64_t seed,
                     double step, bool compat)
    : random_(sensorStream(seed, identity)), period_(sensorCycle(model.declaration, step)) {
  const double period = static_cast<double>(period_) * step;
  rate_ =
      triad(readInertialNoise(model.declaration, "gyroscope", compat), period, kGyroscope, compat);
  force_ = triad(readInertialNoise(model.declaration, "accelerometer", compat), period,
                 kAccelerometer, compat);
}

ImuSensor::Triad ImuSensor::triad(const InertialNoise& n, double period, int first_draw,
                                  bool compat) const {
  Triad t;
  t.white = n.density / std::sqrt(period);
  t.decay = std::exp(-period / n.correlation_time);
  t.drive = n.random_walk *
            std::sqrt(-0.5 * n.correlation_time * std::expm1(-2 * period / n.correlation_time));
  t.variance = compat ? n.density * n.density : t.white * t.white;
  for (int axis = 0; axis < 3; ++axis) {
    t.turn_on[axis] =
        n.turn_on_sigma * random_.normal(kTurnOn, static_cast<std::uint64_t>(first_draw + axis));
  }
  return t;
}

void ImuSensor::moveBiasesTo(std::int64_t sample) {
  if (sample < bias_sample_) {  // back in time: once more from the start
    bias_sample_ = -1;
    rate_.bias.setZero();
    force_.bias.setZero();
  }
  while (bias_sample_ < sample) {
    const auto at = static_cast<std::uint64_t>(++bias_sample_);
    for (int axis = 0; axis < 3; ++axis) {
      const auto draw = static_cast<std::uint64_t>(axis);
      for (Triad* t : {&rate_, &force_}) {
        if (t->drive == 0) continue;
        const double n = random_.normal(at, draw + (t == &rate_ ? kGyroscope : kAccelerometer));
        t->bias[axis] = t->decay * t->bias[axis] + t->drive * n;
      }
    }
  }
}

ImuReading ImuSensor::sense(const ImuReading& truth, std::int64_t step) {
  const std::int64_t sample = step / period_;
  moveBiasesTo(sample);
  ImuReading out = truth;
  const auto noise = [&](const Triad& t, int axis, int first) {
    const auto draw = static_cast<std::uint64_t>(kWhite + first + axis);
    const double white =
        t.white == 0 ? 0 : t.white * random_.normal(static_cast<std::uint64_t>(sample), draw);
    return t.turn_on[axis] + t.bias[axis] + white;
  };
  for (int axis = 0; axis < 3; ++axis) {
    out.rate_S[axis] += noise(rate_, axis, kGyroscope);
    out.specific_force_S[axis] += noise(force_, axis, kAccelerometer);
  }
  return out;
}

}  // namespace quad_sim
