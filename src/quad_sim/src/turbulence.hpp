/// Dryden's turbulence: three filtered noises along and across the mean wind. Not installed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "quad_sim/plugin.hpp"
#include "quad_support/random_stream.hpp"

namespace quad_sim {

/// Tags turbulenceIntensity (sigma of u, v, w [m/s]; absent: no turbulence), turbulenceLength (L of
/// u, v, w [m]) and turbulenceSpeed (V [m/s] at which the frozen field passes; the mean wind if
/// absent).
struct TurbulenceSettings {
  /// @param mean_speed  of the wind [m/s]
  TurbulenceSettings(const PluginDeclaration& declaration, double mean_speed);
  Eigen::Vector3d intensity = Eigen::Vector3d::Zero();
  Eigen::Vector3d length = Eigen::Vector3d::Ones();
  double speed = 1;
};

/// The spectra of MIL-F-8785C, one-sided in w [rad/s], with T = L/V:
///   Phi_u = sigma² (2 T/pi) / (1 + (T w)²),  Phi_v,w = sigma² (T/pi) (1 + 3 (T w)²) / (1 + (T
///   w)²)².
/// u lies along the mean wind, v level across it, w completes them. Each is a linear filter of
/// white noise; a step of it is taken exactly, so variance and correlation do not depend on the
/// step. Numbers are drawn by (seed, stream, step).
class Turbulence {
 public:
  Turbulence(const TurbulenceSettings& settings, const Eigen::Vector3d& along_W,
             const WorldSettings& world);
  bool blows() const { return blows_; }
  /// Velocity of the air [m/s], world axes, for the step of that number. The first call after
  /// restart() draws the stationary state.
  Eigen::Vector3d next(std::int64_t step);
  void restart() { started_ = 0; }
  void archive(StateArchive& archive);

 private:
  /// x1' = (-x1 + n)/T, x2' = (-x2 + x1)/T: x1 and x2 have variances 1 and 1/2 and covariance 1/2.
  struct Filter {
    double sigma;
    bool across;                       ///< v or w: zeros in the spectrum's numerator
    double decay, couple;              ///< exp(-h/T), (h/T) exp(-h/T)
    double noise11, noise21, noise22;  ///< Cholesky factor of a step's noise
    double x1 = 0, x2 = 0;
  };
  static Filter makeFilter(double sigma, double time_constant, double step, bool across);

  std::array<Filter, 3> filters_;
  Eigen::Matrix3d axes_W_;  ///< u, v, w as columns
  quad_support::RandomStream random_;
  bool blows_;
  std::int64_t started_ = 0;
};

}  // namespace quad_sim
