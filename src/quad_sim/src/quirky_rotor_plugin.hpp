/// The rotors with some of RotorS's peculiarities, as a plugin. Not installed.
#pragma once

#include <vector>

#include "quad_sim/plugin.hpp"

namespace quad_sim {

/// As RotorPlugin, with the switches of RotorsQuirks that concern motors; see there. Speeds are
/// signed here, because unchecked commands may be negative: a rotor that turns backwards thrusts
/// backwards.
class QuirkyRotorPlugin : public Plugin {
 public:
  QuirkyRotorPlugin(const VehicleModel& model, const WorldSettings& world);

  void step(const StepInput& input, StepLoad& load) override;
  void restore(const VehicleState& state) override;
  void reset(const VehicleState& state) override;
  void save(VehicleState& state) const override;
  void archive(StateArchive& archive) override;
  Eigen::Vector3d momentum() const override;

 private:
  struct Rotor {
    const RotorModel* model;
    Eigen::Vector3d hub_C;
    double speed;  ///< [rad/s], positive in the rotor's own turning direction
  };
  /// Moves the speed by one step of the filter; returns the mean of the speed and of its square
  /// with sign.
  struct Means {
    double speed, square;
  };
  Means filter(Rotor& rotor, double command, double dt) const;
  void addLoad(const Rotor& rotor, const Means& mean, const StepInput& input, StepLoad& load) const;

  std::vector<RotorModel> models_;
  std::vector<Rotor> rotors_;
  RotorsQuirks quirks_;
  double step_;
  double last_time_ = 0;  ///< end of the last step [s]
};

}  // namespace quad_sim
