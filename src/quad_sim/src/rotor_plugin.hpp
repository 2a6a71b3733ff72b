/// The vehicle's rotors, as a plugin. Not installed.
#pragma once

#include <vector>

#include "quad_sim/plugin.hpp"

namespace quad_sim {

/// All rotors of a vehicle: speed lag, thrust, drag torque, H-force, rolling moment, angular
/// momentum.
///
/// Over one step the command is constant, so the speed is w(t) = u + (w0 - u) exp(-t/tau) exactly;
/// thrust uses the exact mean of w² over the step and the drag terms the exact mean of w. So the
/// impulse does not depend on the step. Sources: thesis Eq. (1.1); H-force and rolling moment as in
/// RotorS's motor model, the latter with the turning direction, which RotorS leaves out.
class RotorPlugin : public Plugin {
 public:
  RotorPlugin(const VehicleModel& model, double step);

  void step(const StepInput& input, StepLoad& load) override;
  void restore(const VehicleState& state) override;
  void save(VehicleState& state) const override;
  void archive(StateArchive& archive) override;
  Eigen::Vector3d momentum() const override;

 private:
  /// Of exp(-t/tau) over a step h: value at the end, mean, mean of the square.
  struct Decay {
    double end, mean, mean_square;
  };
  struct Rotor {
    double speed;  ///< [rad/s], >= 0
    Decay up, down;
    Eigen::Vector3d hub_C;  ///< from the centre of mass [m]
    Eigen::Vector3d axis;
    Eigen::Vector3d thrust_force, thrust_torque;  ///< per w²: k_f e, and r x k_f e - s k_f ratio e
    double drag;                                  ///< [N s²/(m rad)]
    double rolling;                               ///< s * coefficient
    Eigen::Vector3d momentum;                     ///< per w: s J e
  };
  static Decay decayOver(double step, double time_constant);

  void stepUpright(const StepInput& input, StepLoad& load);
  void stepAnyAxis(const StepInput& input, StepLoad& load);

  std::vector<Rotor> rotors_;
  bool upright_ = true;  ///< every axis is base_link's z
};

}  // namespace quad_sim
