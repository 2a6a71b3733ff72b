/// The Hummingbird by Newton and Euler, written down a second time. Shares no code with src/:
/// figures, inertia, forces and integrator are its own, so that an error has to be made twice to go
/// unseen.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <functional>

namespace reference {

using Speeds = std::array<double, 4>;

struct State {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();            ///< of base_link's origin, world [m]
  Eigen::Vector3d v = Eigen::Vector3d::Zero();            ///< of base_link's origin, world [m/s]
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();  ///< body to world
  Eigen::Vector3d w = Eigen::Vector3d::Zero();            ///< body rates [rad/s]
  Speeds rotor{};                                         ///< [rad/s]
};

/// Commanded rotor speeds at a time [s]; may jump only at whole multiples of 0.01 s.
using Command = std::function<Speeds(double t)>;

enum class Method {
  kRungeKutta4,        ///< error of order h^4: the truth, at a tenth of a millisecond
  kSemiImplicitEuler,  ///< velocities first, then poses with the new velocities: the honest
                       ///< first-order method
};

/// Integrates from t = 0 to `duration` [s] in steps of `h` [s] that divide 0.01 s.
State integrate(const State& start, const Command& command, double duration, double h,
                Method method);

/// Speed of four equal rotors that carries the weight [rad/s].
double hoverSpeed();

/// Greatest difference of positions [m], velocities, attitude [rad], rates, and rotor speeds
/// [rad/s] / 100.
double distance(const State& a, const State& b);

}  // namespace reference
