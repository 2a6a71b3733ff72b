#include "newton_euler_reference.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// RotorS's Hummingbird, with ground-truth sensors.
constexpr double kGravity = 9.8;
constexpr double kBaseMass = 0.68, kRotorMass = 0.009, kImuMass = 0.015, kMarkerMass = 1e-5;
constexpr double kMass = kBaseMass + 4 * kRotorMass + kImuMass + 3 * kMarkerMass;
constexpr double kArm = 0.17, kHeight = 0.01;
constexpr double kThrust = 8.54858e-06, kMoment = 0.016, kDrag = 8.06428e-05, kRolling = 1e-6;
constexpr double kUp = 0.0125, kDown = 0.025, kMaxSpeed = 838.0;
const std::array<Vector3d, 4> kHub = {Vector3d(kArm, 0, kHeight), Vector3d(0, kArm, kHeight),
                                      Vector3d(-kArm, 0, kHeight), Vector3d(0, -kArm, kHeight)};
constexpr std::array<int, 4> kSpin = {-1, 1, -1, 1};
// A rotor: a box of 0.1 x 0.015 x 0.003 m, as RotorS's macro computes it (with 0.0833333 for a
// twelfth).
constexpr double kBox = 0.0833333 * kRotorMass;
constexpr double kAxial = kBox * (0.1 * 0.1 + 0.015 * 0.015);
constexpr double kTransverse = 0.5 * kBox * (0.1 * 0.1 + 0.015 * 0.015 + 2 * 0.003 * 0.003);

Vector3d centreOfMass() { return Vector3d(0, 0, 4 * kRotorMass * kHeight / kMass); }

Matrix3d inertia() {
  constexpr double kSensors = 4 * 1e-5;  // four sensor links of 1e-5 kg m² about each axis
  const Vector3d c = centreOfMass();
  Matrix3d I = Vector3d(0.007 + kSensors, 0.007 + kSensors, 0.012 + kSensors).asDiagonal();
  for (const Vector3d& r : kHub) {
    I += Vector3d(kTransverse, kTransverse, kAxial).asDiagonal();
    I += kRotorMass * (r.dot(r) * Matrix3d::Identity() - r * r.transpose());
  }
  return I - kMass * (c.dot(c) * Matrix3d::Identity() - c * c.transpose());
}

/// Unknowns at the centre of mass: position, velocity, quaternion as a 4-vector (w, x, y, z),
/// rates, rotor speeds.
struct Unknowns {
  Vector3d p, v;
  Eigen::Vector4d q;
  Vector3d w;
  Eigen::Vector4d rotor;
};

Unknowns add(const Unknowns& a, const Unknowns& d, double h) {
  return {a.p + h * d.p, a.v + h * d.v, a.q + h * d.q, a.w + h * d.w, a.rotor + h * d.rotor};
}

Matrix3d rotation(const Eigen::Vector4d& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// Quaternion rate (1/2) q * (0, w).
Eigen::Vector4d turning(const Eigen::Vector4d& q, const Vector3d& w) {
  return 0.5 * Eigen::Vector4d(-q[1] * w[0] - q[2] * w[1] - q[3] * w[2],
                               q[0] * w[0] + q[2] * w[2] - q[3] * w[1],
                               q[0] * w[1] + q[3] * w[0] - q[1] * w[2],
                               q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
}

/// Newton's and Euler's equations: m v' = R F - m g; (I w + h)' + w x (I w + h) = tau, h the
/// rotors' momentum.
Unknowns derivative(const Unknowns& x, const Speeds& command) {
  static const Matrix3d I = inertia(), I_inverse = I.inverse();
  static const Vector3d c = centreOfMass();
  const Matrix3d R = rotation(x.q);
  const Vector3d v_B = R.transpose() * x.v;
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero(), momentum = Vector3d::Zero(),
           momentum_rate = Vector3d::Zero();
  Unknowns d;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double target = std::clamp(command[i], 0.0, kMaxSpeed), speed = x.rotor[k];
    d.rotor[k] = (target - speed) / (target > speed ? kUp : kDown);
    const double thrust = kThrust * speed * speed;
    const Vector3d arm = kHub[i] - c;
    const Vector3d hub_velocity = v_B + x.w.cross(arm);
    const Vector3d across(hub_velocity.x(), hub_velocity.y(), 0);
    const Vector3d on_hub = Vector3d(0, 0, thrust) - std::abs(speed) * kDrag * across;
    force += on_hub;
    torque += arm.cross(on_hub) - Vector3d(0, 0, kSpin[i] * kMoment * thrust) -
              kSpin[i] * std::abs(speed) * kRolling * across;
    momentum.z() += kSpin[i] * kAxial * speed;
    momentum_rate.z() += kSpin[i] * kAxial * d.rotor[k];
  }
  d.p = x.v;
  d.v = R * force / kMass - Vector3d(0, 0, kGravity);
  d.q = turning(x.q, x.w);
  d.w = I_inverse * (torque - momentum_rate - x.w.cross(I * x.w + momentum));
  return d;
}

Unknowns rungeKutta(const Unknowns& x, const Speeds& u, double h) {
  const Unknowns a = derivative(x, u), b = derivative(add(x, a, h / 2), u),
                 c = derivative(add(x, b, h / 2), u), d = derivative(add(x, c, h), u);
  Unknowns y = add(add(add(add(x, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  y.q.normalize();
  return y;
}

Unknowns semiImplicitEuler(const Unknowns& x, const Speeds& u, double h) {
  const Unknowns d = derivative(x, u);
  Unknowns y = add(x, d, h);
  y.p = x.p + h * y.v;
  y.q = (x.q + h * turning(x.q, y.w)).normalized();
  return y;
}

}  // namespace

double hoverSpeed() { return std::sqrt(kMass * kGravity / (4 * kThrust)); }

State integrate(const State& start, const Command& command, double duration, double h,
                Method method) {
  const Vector3d c = centreOfMass();
  const Matrix3d R0 = start.q.normalized().toRotationMatrix();
  Unknowns x{start.p + R0 * c, start.v + R0 * start.w.cross(c),
             Eigen::Vector4d(start.q.w(), start.q.x(), start.q.y(), start.q.z()), start.w,
             Eigen::Vector4d(start.rotor[0], start.rotor[1], start.rotor[2], start.rotor[3])};
  const long steps = std::lround(duration / h);
  for (long k = 0; k < steps; ++k) {
    const Speeds u = command((static_cast<double>(k) + 0.5) * h);  // the middle: no doubt at a jump
    x = method == Method::kRungeKutta4 ? rungeKutta(x, u, h) : semiImplicitEuler(x, u, h);
  }
  State end;
  end.q = Eigen::Quaterniond(x.q[0], x.q[1], x.q[2], x.q[3]);
  const Matrix3d R = end.q.toRotationMatrix();
  end.p = x.p - R * c;
  end.v = x.v - R * x.w.cross(c);
  end.w = x.w;
  for (std::size_t i = 0; i < 4; ++i) end.rotor[i] = x.rotor[static_cast<Eigen::Index>(i)];
  return end;
}

double distance(const State& a, const State& b) {
  double worst =
      std::max({(a.p - b.p).cwiseAbs().maxCoeff(), (a.v - b.v).cwiseAbs().maxCoeff(),
                (a.w - b.w).cwiseAbs().maxCoeff(), 2 * (a.q.conjugate() * b.q).vec().norm()});
  for (std::size_t i = 0; i < 4; ++i)
    worst = std::max(worst, std::abs(a.rotor[i] - b.rotor[i]) / 100);
  return worst;
}

}  // namespace reference
