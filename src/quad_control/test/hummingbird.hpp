/// The Hummingbird's figures (RotorS's hummingbird.xacro), written down apart from the URDF for
/// tests of single units.
#pragma once

#include <vector>

#include "quad_control/mixer.hpp"
#include "sampled_loop.hpp"

namespace quad_control::test {

constexpr double kThrustCoefficient = 8.54858e-06, kMomentConstant = 0.016, kArm = 0.17,
                 kMaxSpeed = 838.0;

/// Motors front, left, back, right; front and back clockwise (RotorS's order).
inline std::vector<RotorGeometry> hummingbirdRotors() {
  const Eigen::Vector3d places[4] = {
      {kArm, 0, 0.01}, {0, kArm, 0.01}, {-kArm, 0, 0.01}, {0, -kArm, 0.01}};
  std::vector<RotorGeometry> rotors;
  for (int i = 0; i < 4; ++i) {
    rotors.push_back({places[i], Eigen::Vector3d::UnitZ(), i % 2 == 0 ? -1 : 1, kThrustCoefficient,
                      kMomentConstant, kMaxSpeed});
  }
  return rotors;
}

/// Totals of the whole vehicle: body, rotors and sensors.
inline LoopVehicle hummingbirdLoops() {
  LoopVehicle vehicle;
  vehicle.mass = 0.73;
  vehicle.inertia_xx = 0.0077;
  vehicle.inertia_zz = 0.0131;
  vehicle.thrust_coefficient = kThrustCoefficient;
  vehicle.drag_coefficient = 8.06428e-05;
  vehicle.rolling_moment_coefficient = 1e-06;
  vehicle.rotor_height = 0.01 - 0.000492;
  return vehicle;
}

}  // namespace quad_control::test
