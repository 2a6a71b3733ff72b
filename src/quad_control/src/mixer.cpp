#include "quad_control/mixer.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "quad_support/errors.hpp"
#include "quad_support/linear_algebra.hpp"

namespace quad_control {
namespace {

using quad_support::ConfigError;
using AllocationMatrix = Eigen::Matrix<double, 4, Eigen::Dynamic>;

// Singular values of the row-normalised K of a sound vehicle lie within a factor of some tens of
// each other; rounding leaves about 1e-16 where one is missing. Anything between is a vehicle that
// has a direction in name only.
constexpr double kRankTolerance = 1e-6;

void check(const RotorGeometry& rotor, std::size_t index) {
  const auto fail = [index](const char* what, double value, const char* limit) {
    throw ConfigError(fmt::format("control allocation: rotor {}: {} = {}; must be {}", index, what,
                                  value, limit));
  };
  if (!rotor.position_B.allFinite()) fail("position_B", rotor.position_B.sum(), "finite");
  if (!(std::abs(rotor.axis_B.norm() - 1.0) < 1e-6)) fail("|axis_B|", rotor.axis_B.norm(), "1");
  if (std::abs(rotor.spin) != 1)
    fail("spin", rotor.spin, "+1 (counter-clockwise) or -1 (clockwise)");
  if (!(rotor.thrust_coefficient > 0.0))
    fail("thrust_coefficient", rotor.thrust_coefficient, "> 0 N/(rad/s)^2");
  if (!std::isfinite(rotor.moment_constant))
    fail("moment_constant", rotor.moment_constant, "finite");
  if (!(rotor.max_speed > 0.0)) fail("max_speed", rotor.max_speed, "> 0 rad/s");
}

AllocationMatrix allocationMatrix(const std::vector<RotorGeometry>& rotors) {
  if (rotors.empty())
    throw ConfigError("control allocation: the vehicle has 0 rotors; at least four are needed");
  AllocationMatrix matrix(4, static_cast<Eigen::Index>(rotors.size()));
  for (std::size_t i = 0; i < rotors.size(); ++i) {
    check(rotors[i], i);
    const RotorGeometry& r = rotors[i];
    const Eigen::Vector3d torque =
        r.position_B.cross(r.axis_B) - r.spin * r.moment_constant * r.axis_B;
    matrix.col(static_cast<Eigen::Index>(i)) << r.axis_B.z(), torque;
    matrix.col(static_cast<Eigen::Index>(i)) *= r.thrust_coefficient;
  }
  return matrix;
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

/// What a vehicle cannot do. An axis can be commanded alone if its unit vector is in the range of
/// K, that is orthogonal to the null space of Kᵀ (columns of `lost`, orthonormal). Where it lies
/// within that space, its row of K is zero; otherwise the rotors give the axis only together with
/// others.
std::string describeLoss(const Eigen::MatrixXd& lost) {
  static const char* const kNames[4] = {"thrust", "roll torque", "pitch torque", "yaw torque"};
  std::vector<std::string> never, coupled;
  for (int axis = 0; axis < 4; ++axis) {
    const double part = lost.row(axis).norm();
    if (part < kRankTolerance) continue;
    (1.0 - part < kRankTolerance ? never : coupled).emplace_back(kNames[axis]);
  }
  std::string text;
  if (!never.empty()) text = listed(never) + " cannot be commanded";
  if (!never.empty() && !coupled.empty()) text += ", and ";
  if (!coupled.empty())
    text += listed(coupled) + " cannot be commanded independently of each other";
  return text;
}

// Thrust and torques have different units, so the rank is judged with every row scaled to length 1.
void requireFullRank(const AllocationMatrix& matrix) {
  AllocationMatrix scaled = matrix;
  for (int row = 0; row < 4; ++row) {
    const double norm = scaled.row(row).norm();
    // A row that holds but rounding is no axis either; the other rows tell how large K's entries
    // are.
    const double size = row == 0 ? 0.0 : matrix.row(0).norm();
    if (norm > kRankTolerance * kRankTolerance * size) scaled.row(row) /= norm;
  }
  const Eigen::VectorXd sigma = quad_support::singularValues(scaled);
  int rank = 0;
  while (rank < sigma.size() && sigma(rank) > kRankTolerance * sigma(0)) ++rank;
  if (rank == 4) return;
  throw ConfigError(
      fmt::format("control allocation: {} rotors give a matrix of rank {} of 4, so {}; check the "
                  "rotors' positions, axes and turning "
                  "directions, or fly a vehicle with at least four rotors",
                  matrix.cols(), rank,
                  describeLoss(quad_support::leftSingularVectors(scaled).rightCols(4 - rank))));
}

}  // namespace

Mixer::Mixer(const std::vector<RotorGeometry>& rotors) : matrix_(allocationMatrix(rotors)) {
  requireFullRank(matrix_);
  // K has full row rank, so K⁺ = Kᵀ (K Kᵀ)⁻¹. The rows of K differ by orders of magnitude; QR of Kᵀ
  // does not square that, and for four rotors it is the plain inverse.
  const Eigen::MatrixXd transposed = matrix_.transpose();
  inverse_ = transposed.completeOrthogonalDecomposition().pseudoInverse().transpose();
  max_squared_speed_.resize(static_cast<Eigen::Index>(rotors.size()));
  for (std::size_t i = 0; i < rotors.size(); ++i) {
    max_squared_speed_(static_cast<Eigen::Index>(i)) = rotors[i].max_speed * rotors[i].max_speed;
  }
}

Allocation Mixer::allocate(const ControlInput& input) const {
  Allocation result;
  result.rotor_speed.resize(static_cast<std::size_t>(numRotors()));
  for (int i = 0; i < numRotors(); ++i) {
    const double wanted = inverse_.row(i).dot(input);
    const double given = std::clamp(wanted, 0.0, max_squared_speed_(i));
    if (!(given == wanted)) ++result.clamped;
    result.rotor_speed[static_cast<std::size_t>(i)] = std::sqrt(given);
  }
  return result;
}

ControlInput Mixer::controlInput(const std::vector<double>& rotor_speed) const {
  if (static_cast<int>(rotor_speed.size()) != numRotors()) {
    throw quad_support::DataError(
        fmt::format("control allocation: {} rotor speeds for a vehicle of {} rotors",
                    rotor_speed.size(), numRotors()));
  }
  ControlInput input = ControlInput::Zero();
  for (int i = 0; i < numRotors(); ++i) {
    const double speed = rotor_speed[static_cast<std::size_t>(i)];
    input += matrix_.col(i) * (speed * speed);
  }
  return input;
}

double Mixer::margin(const ControlInput& input, int axis) const {
  double margin = std::numeric_limits<double>::infinity();
  for (int i = 0; i < numRotors(); ++i) {
    const double squared = inverse_.row(i).dot(input);
    const double room = std::min(squared, max_squared_speed_(i) - squared);
    const double slope = std::abs(inverse_(i, axis));
    if (slope > 0.0) margin = std::min(margin, std::max(room, 0.0) / slope);
  }
  return margin;
}

double Mixer::maxThrust() const { return matrix_.row(0).dot(max_squared_speed_); }

}  // namespace quad_control
