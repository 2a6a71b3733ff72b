/// One rigid body in an ODE world, with turning parts inside. Not installed.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "body.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

struct OdeWorld;  // ode_world.hpp

/// The vehicle as one ODE body at its centre of mass C.
///
/// ODE moves and turns the body and solves the contacts; forces come in as changes of momentum made
/// here. The angular momentum about C is kept in world axes, the turning parts' share included, so
/// gyroscopic torque and spin-up reaction need no term of their own and torque-free tumbling
/// conserves it. The rate ODE turns the body with solves the implicit midpoint rule, which
/// conserves the rotational energy too (ODE's own gyroscopic modes dissipate it).
class RigidBody : public Body {
 public:
  RigidBody(const VehicleModel& model, const WorldSettings& world, bool ground);
  ~RigidBody() override;
  RigidBody(const RigidBody&) = delete;
  RigidBody& operator=(const RigidBody&) = delete;

  void restore(const VehicleState& state, const Eigen::Vector3d& momentum_B) override;
  void save(VehicleState& state) const override;
  void archive(StateArchive& archive) override;
  void motion(StepInput& input) const override;
  Eigen::Vector3d specificForce(const Eigen::Vector3d& r_C) const override;
  bool step(const StepLoad& load, const std::vector<double>& rotor_speed) override;
  bool isFinite() const override;
  Wrench groundLoad() const override { return ground_load_; }

 private:
  /// Rate [rad/s, body axes] of the step's rotation: w = I^-1 (Pi_mid - momentum), Pi_mid = Pi + a
  /// Pi_mid x w, where Pi is the angular momentum in body axes and a = h/2, stretched as the rate
  /// ODE is given (see rateStretch()).
  Eigen::Vector3d midpointRate(const Eigen::Vector3d& Pi, const Eigen::Vector3d& momentum_B,
                               double a) const;
  void checkRate(const Eigen::Vector3d& w) const;
  bool move(const StepLoad& load);
  int collide(const Eigen::Matrix3d& R_WB);
  void stepByMidpoint(const Eigen::Matrix3d& R, const StepLoad& load);
  void stepByEuler(const Eigen::Matrix3d& R, const StepLoad& load);
  void stepInContact(const Eigen::Matrix3d& R, const StepLoad& load);
  void refreshBodyRates(const Eigen::Vector3d& momentum_B);

  double h_, gravity_, mass_;
  Eigen::Vector3d com_B_;
  Eigen::Matrix3d inertia_, inverse_inertia_;
  bool euler_;         ///< RotorS's integrator instead of ours
  bool reaction_;      ///< speeding a rotor up turns the body back
  double reach_ = -1;  ///< no point of a box is farther from C [m]; < 0: nothing can touch
  std::vector<CollisionBox> boxes_;
  Eigen::Vector3d v_W_, L_W_;  ///< of C; angular momentum about C
  Eigen::Vector3d v_C_B_, w_B_,
      Pi_B_;  ///< velocity, rate and angular momentum of the same instant in body axes
  Eigen::Vector3d momentum_B_;               ///< of the turning parts, relative to the body
  Eigen::Vector3d v_before_W_, w_before_B_;  ///< at the start of the last step
  Wrench ground_load_;
  std::unique_ptr<OdeWorld> ode_;
};

}  // namespace quad_sim
