#include "turbulence.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace quad_sim {

using Eigen::Vector3d;

TurbulenceSettings::TurbulenceSettings(const PluginDeclaration& p, double mean_speed) {
  intensity = p.vector("turbulenceIntensity", Vector3d::Zero());
  if (!(intensity.minCoeff() >= 0))
    p.fail("turbulenceIntensity", "must be three numbers >= 0 [m/s]");
  if (intensity == Vector3d::Zero()) return;
  length = p.vector("turbulenceLength");
  if (!(length.minCoeff() > 0)) p.fail("turbulenceLength", "must be three numbers > 0 [m]");
  speed = p.number("turbulenceSpeed", std::abs(mean_speed));
  if (!(speed > 0))
    p.fail("turbulenceSpeed",
           "must be > 0 m/s: without mean wind it says how fast the frozen field passes");
}

Turbulence::Filter Turbulence::makeFilter(double sigma, double time_constant, double step,
                                          bool across) {
  const double r = step / time_constant, a = std::exp(-r);
  Filter f{sigma, across, a, r * a, 0, 0, 0};
  // Covariance of a step's noise: P - F P F^T with P = [1 1/2; 1/2 1/2], F = [a 0; r a a]. Its
  // entries are of order r, r², r³: written as series where the differences would cancel.
  double q11, q21, q22;
  if (r > 1e-2) {
    q11 = 1 - a * a;
    q21 = 0.5 - a * a * (r + 0.5);
    q22 = 0.5 - a * a * (r * r + r + 0.5);
  } else {  // next terms: relative 2/3 r³ and less, below 1e-6 of a small noise
    q11 = -std::expm1(-2 * r);
    q21 = r * r * (1 - 4.0 / 3 * r + r * r);
    q22 = r * r * r * (2.0 / 3 - r + 0.8 * r * r);
  }
  f.noise11 = std::sqrt(q11);
  f.noise21 = q21 / f.noise11;
  f.noise22 = std::sqrt(std::max(0.0, q22 - f.noise21 * f.noise21));
  return f;
}

namespace {

constexpr std::uint64_t kWindStream = 0x77696e64;  // "wind": no other purpose draws from it

/// u along the mean wind, v level across it, w completes them.
Eigen::Matrix3d windAxes(const Vector3d& along) {
  const Vector3d level = Vector3d::UnitZ().cross(along);
  const Vector3d v = level.norm() > 1e-9 ? level.normalized() : Vector3d::UnitY();
  Eigen::Matrix3d axes;
  axes << along, v, along.cross(v);
  return axes;
}

}  // namespace

Turbulence::Turbulence(const TurbulenceSettings& s, const Vector3d& along_W,
                       const WorldSettings& world)
    : axes_W_(windAxes(along_W)),
      random_(world.seed, 0, kWindStream),
      blows_(s.intensity != Vector3d::Zero()) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    filters_[i] = makeFilter(s.intensity[k], s.length[k] / s.speed, world.step, i > 0);
  }
}

Vector3d Turbulence::next(std::int64_t step) {
  Vector3d gust;
  for (std::size_t i = 0; i < 3; ++i) {
    Filter& f = filters_[i];
    const double n1 = random_.normal(static_cast<std::uint64_t>(step), 2 * i);
    const double n2 = random_.normal(static_cast<std::uint64_t>(step), 2 * i + 1);
    if (started_ == 0) {
      f.x1 = n1;
      f.x2 = 0.5 * n1 + 0.5 * n2;
    } else {
      f.x2 = f.couple * f.x1 + f.decay * f.x2 + f.noise21 * n1 + f.noise22 * n2;
      f.x1 = f.decay * f.x1 + f.noise11 * n1;
    }
    // (1 + sqrt(3) T s)/(1 + T s)² = sqrt(3)/(1 + T s) + (1 - sqrt(3))/(1 + T s)²; the sum's
    // variance is 2.
    constexpr double kRoot3 = 1.7320508075688772, kRootHalf = 0.7071067811865476;
    gust[static_cast<Eigen::Index>(i)] =
        f.sigma * (f.across ? kRootHalf * (kRoot3 * f.x1 + (1 - kRoot3) * f.x2) : f.x1);
  }
  started_ = 1;
  return axes_W_ * gust;
}

void Turbulence::archive(StateArchive& archive) {
  for (Filter& f : filters_) {
    archive(f.x1);
    archive(f.x2);
  }
  archive(started_);
}

}  // namespace quad_sim
