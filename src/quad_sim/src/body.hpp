/// The vehicle's motion in a rigid-body world, however many bodies it is made of. Not installed.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "quad_sim/plugin.hpp"
#include "quad_sim/simulator.hpp"

namespace quad_sim {

class Body {
 public:
  virtual ~Body() = default;

  /// Takes pose and velocity; momentum_B [N m s] is that of the turning parts relative to the body.
  virtual void restore(const VehicleState& state, const Eigen::Vector3d& momentum_B) = 0;
  virtual void save(VehicleState& state) const = 0;  ///< pose and velocity of base_link's origin

  virtual void archive(
      StateArchive& archive) = 0;  ///< pose, momentum and what follows from them, bit for bit

  /// Velocities in body axes for the plugins, and the pose.
  virtual void motion(StepInput& input) const = 0;
  /// Specific force [m/s²], body axes, at r_C from the centre of mass (body axes): its mean over
  /// the last step.
  virtual Eigen::Vector3d specificForce(const Eigen::Vector3d& r_C) const = 0;

  /// One physics step under the load. `rotor_speed` [rad/s] are the rotors' speeds at its end, by
  /// motor number. Returns whether the vehicle touched the ground.
  /// @throws quad_support::SimulationError if the vehicle turns by more than a radian in the step
  virtual bool step(const StepLoad& load, const std::vector<double>& rotor_speed) = 0;
  virtual bool isFinite() const = 0;
  /// What the ground put on the vehicle in the last step that touched it.
  virtual Wrench groundLoad() const = 0;

  /// Place and motion of the rotors' own bodies; empty if they have none.
  virtual std::vector<RotorState> rotors() const { return {}; }
};

}  // namespace quad_sim
