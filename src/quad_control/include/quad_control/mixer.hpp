/// Control allocation: thrust and torques to rotor speeds, and back.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace quad_control {

/// The control input U = [T, τφ, τθ, τψ] of Eq. (1.3): thrust along z_B [N], torques about the axes
/// of B [N m].
using ControlInput = Eigen::Vector4d;

/// What the allocation has to know about a rotor. B: x forward, y left, z up.
struct RotorGeometry {
  Eigen::Vector3d position_B =
      Eigen::Vector3d::Zero();                        ///< from the centre of mass to the rotor [m]
  Eigen::Vector3d axis_B = Eigen::Vector3d::UnitZ();  ///< unit vector along which it pushes
  int spin = 1;                     ///< +1 counter-clockwise seen from above, -1 clockwise
  double thrust_coefficient = 0.0;  ///< k_f [N/(rad/s)²]; > 0
  double moment_constant = 0.0;     ///< k_m / k_f [m]; drag torque per thrust
  double max_speed = 0.0;           ///< [rad/s]; > 0
};

/// Rotor speeds for a control input, and how many of them had to be clamped.
struct Allocation {
  std::vector<double> rotor_speed;  ///< unsigned [rad/s], in the order of the rotors
  int clamped = 0;                  ///< rotors whose ω² was below 0 or above max_speed²
};

/// The allocation matrix K of U = K ω², computed from where the rotors are and which way they turn.
///
/// Column i is k_f [a_z; r × a − spin · (k_m/k_f) · a] for a rotor at r pushing along a: the sum of
/// r × F plus the drag torque, which opposes the spin. Thesis Eq. (1.3) is this matrix for rotors
/// numbered front, right, back, left with the front one turning counter-clockwise; on RotorS's
/// order (front, left, back, right, the front one clockwise) its roll and yaw rows have the
/// opposite sign.
class Mixer {
 public:
  /// @throws quad_support::ConfigError if a figure is out of range, or if K has rank below 4: then
  /// some thrust or torque
  ///         cannot be given, and the text names it
  explicit Mixer(const std::vector<RotorGeometry>& rotors);

  const Eigen::Matrix<double, 4, Eigen::Dynamic>& matrix() const {
    return matrix_;
  }  ///< K [N, N m per (rad/s)²]
  int numRotors() const { return static_cast<int>(max_squared_speed_.size()); }

  /// Rotor speeds that give `input`: ω² = K⁺ U, of least norm where there are more than four
  /// rotors. ω² below zero is clamped to zero, above the maximum to the maximum, and counted.
  Allocation allocate(const ControlInput& input) const;

  /// The control input rebuilt from measured rotor speeds, U^FB = K ω² (thesis section 2.2). The
  /// sign of a speed does not matter. @throws quad_support::DataError if there is not one speed a
  /// rotor
  ControlInput controlInput(const std::vector<double>& rotor_speed) const;

  /// How far entry `axis` (0 thrust, 1 roll, 2 pitch, 3 yaw) of `input` can be moved either way,
  /// alone, before a rotor has to be clamped: the largest s with input ± s e_axis feasible; 0 if
  /// `input` itself is not.
  double margin(const ControlInput& input, int axis) const;

  /// Thrust with all rotors at their maximum [N].
  double maxThrust() const;

 private:
  Eigen::Matrix<double, 4, Eigen::Dynamic> matrix_;
  Eigen::Matrix<double, Eigen::Dynamic, 4> inverse_;
  Eigen::VectorXd max_squared_speed_;  // [(rad/s)²]
};

}  // namespace quad_control
