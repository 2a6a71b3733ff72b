#include "quad_sim/odometry_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;

constexpr double kRotorsCycle = 0.01;  // [s], the physics step of RotorS's worlds
constexpr const char* kQuantities[] = {"Position", "Quaternion", "LinearVelocity",
                                       "AngularVelocity"};

/// "0.01 0.01 0.02": three numbers >= 0; a tag that is absent means none.
Vector3d threeNumbers(const PluginDeclaration& p, const std::string& tag) {
  std::istringstream in(p.text(tag, "0 0 0"));
  Vector3d v;
  std::string word;
  int n = 0;
  for (; in >> word; ++n) {
    try {
      if (n < 3) v[n] = quad_support::parseDouble(word);
    } catch (const std::invalid_argument&) {
      p.fail(tag, "must be three numbers");
    }
  }
  if (n != 3 || !v.allFinite() || v.minCoeff() < 0)
    p.fail(tag, "must be three finite numbers >= 0");
  return v;
}

std::int64_t wholeNumber(const PluginDeclaration& p, const std::string& tag, double fallback,
                         double least) {
  const double x = p.number(tag, fallback);
  constexpr double kMost = 1e6;  // cycles: nearly three hours
  if (x != std::floor(x) || x < least || x > kMost) {
    p.fail(tag,
           "must be a whole number of cycles, " + quad_support::shortest(least) + " to 1000000");
  }
  return static_cast<std::int64_t>(x);
}

std::uint64_t seedOf(const PluginDeclaration& p, std::uint64_t otherwise) {
  if (p.tags.count("randomEngineSeed") == 0) return otherwise;
  const double x = p.number("randomEngineSeed");
  if (x < 0 || x != std::floor(x) || x > 9007199254740992.0)
    p.fail("randomEngineSeed", "must be a whole number >= 0");
  return static_cast<std::uint64_t>(x);
}

}  // namespace

quad_support::RandomStream sensorStream(std::uint64_t seed, const std::string& identity) {
  std::uint64_t hash =
      14695981039346656037ULL;  // FNV-1a: the same on every machine, unlike std::hash
  for (const char c : identity) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return quad_support::RandomStream(seed, 0, hash);
}

std::int64_t sensorCycle(const PluginDeclaration& declaration, double step) {
  double cycle = kRotorsCycle;
  if (declaration.tags.count("updateRate") > 0) {
    const double rate = declaration.number("updateRate");
    if (!(rate > 0)) declaration.fail("updateRate", "must be > 0 Hz");
    cycle = 1 / rate;
  }
  return std::max<std::int64_t>(1, std::llround(std::min(cycle / step, 1e9)));
}

double nonNegative(const PluginDeclaration& declaration, const std::string& tag, double fallback) {
  const double x = declaration.number(tag, fallback);
  if (x < 0) declaration.fail(tag, "must be >= 0");
  return x;
}

OdometrySensor::OdometrySensor(const SensorModel& model, const std::string& identity,
                               std::uint64_t seed, double step, bool compat)
    : random_(sensorStream(seedOf(model.declaration, seed), identity)) {
  const PluginDeclaration& p = model.declaration;
  if (p.text("parentFrameId", "world") != "world")
    p.fail("parentFrameId", "must be world in this version");
  for (std::size_t i = 0; i < noise_.size(); ++i) {
    noise_[i].normal = threeNumbers(p, std::string("noiseNormal") + kQuantities[i]);
    noise_[i].uniform = threeNumbers(p, std::string("noiseUniform") + kQuantities[i]);
    noisy_ = noisy_ || !noise_[i].normal.isZero(0) || !noise_[i].uniform.isZero(0);
    for (int axis = 0; axis < 3; ++axis) {
      // A uniform density on [-u, u] has the variance u²/3. RotorS leaves it out.
      const double u = compat ? 0.0 : noise_[i].uniform[axis];
      const double variance = noise_[i].normal[axis] * noise_[i].normal[axis] + u * u / 3;
      auto& out = i < 2 ? pose_variance_ : twist_variance_;
      out[3 * (i % 2) + static_cast<std::size_t>(axis)] = variance;
    }
  }
  const std::int64_t divisor = wholeNumber(p, "measurementDivisor", 1, 1);
  const std::int64_t delay = wholeNumber(p, "measurementDelay", 0, 0);
  const std::int64_t cycle = sensorCycle(p, step);
  if (divisor > 1 || delay > 0 || p.tags.count("updateRate") > 0) period_ = divisor * cycle;
  delay_ = delay * cycle;
  const double unknown = nonNegative(p, "unknownDelay", 0);
  if (unknown > 1e9) p.fail("unknownDelay", "must be <= 1e9 s");
  extra_stamp_ns_ = std::llround((compat ? std::trunc(unknown) : unknown) * 1e9);
}

Vector3d OdometrySensor::draw(const VectorNoise& noise, std::int64_t step, int quantity) const {
  Vector3d sum;
  const auto at = static_cast<std::uint64_t>(step);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::uint64_t>(3 * quantity + axis);
    constexpr std::uint64_t kUniformDraws = 12;  // behind the twelve normal ones
    sum[axis] = 0;
    if (noise.normal[axis] > 0) sum[axis] += noise.normal[axis] * random_.normal(at, i);
    if (noise.uniform[axis] > 0)
      sum[axis] += noise.uniform[axis] * (2 * random_.uniform(at, kUniformDraws + i) - 1);
  }
  return sum;
}

Odometry OdometrySensor::sense(const Odometry& truth, std::int64_t step) const {
  if (!noisy_) return truth;
  Odometry out = truth;
  out.p_WB += draw(noise_[0], step, 0);
  const Vector3d half =
      0.5 * draw(noise_[1], step, 1);  // small angle: (1, theta/2), in the sensor's axes
  out.q_WB = (out.q_WB * Eigen::Quaterniond(1, half.x(), half.y(), half.z())).normalized();
  out.v_WB_B += draw(noise_[2], step, 2);
  out.w_WB_B += draw(noise_[3], step, 3);
  return out;
}

std::int64_t OdometryDelay::nextEvent(std::int64_t step) const {
  const std::int64_t sample = (step / sensor_.period() + 1) * sensor_.period();
  for (const Sample& s : waiting_) {
    if (s.due > step) return std::min(sample, s.due);
  }
  return sample;
}

std::optional<Odometry> OdometryDelay::at(std::int64_t step, const Odometry& truth) {
  if (step % sensor_.period() == 0)
    waiting_.push_back({step + sensor_.delay(), sensor_.sense(truth, step)});
  std::optional<Odometry> out;
  while (!waiting_.empty() && waiting_.front().due <= step) {
    out = waiting_.front().odometry;
    waiting_.pop_front();
  }
  return out;
}

void OdometryDelay::archive(StateArchive& archive) {
  auto count = static_cast<std::int64_t>(waiting_.size());
  archive(count);
  if (count < 0 || count > 1000000)
    throw std::out_of_range("OdometryDelay: not a number of samples");
  waiting_.resize(static_cast<std::size_t>(count));
  for (Sample& s : waiting_) {
    archive(s.due);
    archive(s.odometry.time_ns);
    for (Vector3d* v : {&s.odometry.p_WB, &s.odometry.v_WB_B, &s.odometry.w_WB_B}) archive(*v);
    archive(s.odometry.q_WB.coeffs().data(), 4);
  }
}

}  // namespace quad_sim
