/// Wind as a plugin: a force on the vehicle and a motion of the air. Not installed.
#pragma once

#include <Eigen/Core>
#include <string>

#include "quad_sim/plugin.hpp"
#include "quad_support/random_stream.hpp"
#include "turbulence.hpp"

namespace quad_sim {

/// What the declaration says, besides what RotorS's wind plugin knows: sinusoids and turbulence.
///
/// Force at base_link's origin + xyzOffset: windForceMean along windDirection, plus
/// windForceAmplitude sin(2 pi windFrequency t + windPhase) along it, plus windGustForceMean along
/// windGustDirection from windGustStart for windGustDuration. Velocity of the air: windSpeedMean
/// along windDirection, plus windSpeedAmplitude with the same sine, plus turbulence. As in RotorS,
/// force and velocity are independent inputs; the velocity acts through the rotors' drag.
struct WindSettings {
  explicit WindSettings(const PluginDeclaration& declaration);

  Eigen::Vector3d offset_B = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d direction_W, gust_direction_W;          ///< unit vectors
  double force = 0, force_amplitude = 0, gust_force = 0;  ///< [N]
  double gust_start = 0, gust_duration = 0;               ///< [s]
  double speed = 0, speed_amplitude = 0;                  ///< [m/s]
  double frequency = 0, phase = 0;                        ///< [Hz], [rad]
};

class WindPlugin : public Plugin {
 public:
  WindPlugin(const VehicleModel& model, const WorldSettings& world);

  bool movesAir() const override { return moves_air_; }
  void addWind(const StepInput& input, Eigen::Vector3d& wind_W) override;
  void step(const StepInput& input, StepLoad& load) override;
  void restore(const VehicleState& state) override;
  void save(VehicleState&) const override {}
  void archive(StateArchive& archive) override;
  Eigen::Vector3d outsideForce() const override { return force_W_; }

 private:
  double sine(double time) const;

  WindSettings settings_;
  Eigen::Vector3d arm_C_;  ///< where the force acts, from the centre of mass, body axes [m]
  Turbulence turbulence_;
  bool moves_air_;
  double step_;
  Eigen::Vector3d force_W_ = Eigen::Vector3d::Zero();
};

}  // namespace quad_sim
