/// The vehicle as one ODE body for the base and one on a hinge for each rotor, as RotorS builds it.
/// Not installed.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "body.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

struct OdeWorld;  // ode_world.hpp

/// ODE moves and turns every body by itself. What holds them together in the air is solved here: a
/// hinge whose motor keeps a given speed leaves its rotor no freedom of its own, so the sums of
/// linear and angular momentum over all bodies give the base's six velocities exactly, and those
/// give the rotors'. That is the answer ODE's solvers look for with five or six rows a hinge, by
/// one 3 x 3 system. Drift of a rotor off its hinge is led back as ODE does it (erp). On the ground
/// the hinges are ODE joints with motors, solved by QuickStep together with the contacts.
///
/// Poses move with the mean of the velocities before and after; the velocities after follow from
/// the momentum, which the poses do not change. So a free tumble keeps its angular momentum to
/// rounding and its energy to second order in the step. A rotor's inertia is taken as round about
/// its axis, for a blade turns by tens of degrees in a step. With RotorsQuirks::euler_integration
/// or no_spin_reaction: velocities first, then poses with them, as in Gazebo.
class HingedBody : public Body {
 public:
  HingedBody(const VehicleModel& model, const WorldSettings& world, bool ground);
  ~HingedBody() override;
  HingedBody(const HingedBody&) = delete;
  HingedBody& operator=(const HingedBody&) = delete;

  void restore(const VehicleState& state, const Eigen::Vector3d& momentum_B) override;
  void save(VehicleState& state) const override;
  void archive(StateArchive& archive) override;
  void motion(StepInput& input) const override;
  Eigen::Vector3d specificForce(const Eigen::Vector3d& r_C) const override;
  bool step(const StepLoad& load, const std::vector<double>& rotor_speed) override;
  bool isFinite() const override;
  Wrench groundLoad() const override { return ground_load_; }
  std::vector<RotorState> rotors() const override;

 private:
  struct Rotor;
  /// The base's velocities.
  struct Twist {
    Eigen::Vector3d v_W;  ///< of the base's own centre of mass [m/s], world axes
    Eigen::Vector3d w_W;  ///< [rad/s], world axes
  };
  /// Momentum of all bodies together, about the base's centre of mass: what the hinges cannot
  /// change.
  struct Momentum {
    Eigen::Vector3d linear, angular;
  };

  Momentum momentum(const Eigen::Matrix3d& R) const;
  /// Angular momentum about the vehicle's centre of mass instead of the base's.
  Momentum aboutCentre(Momentum sum, const Eigen::Matrix3d& R) const;
  void addGyroscopicTorques(Momentum& sum, const Eigen::Matrix3d& R) const;
  void addImpulse(const StepLoad& load, const Eigen::Matrix3d& R, Momentum& sum) const;
  /// The velocities that have that momentum and leave each rotor only its motor's speed; `erp` of
  /// what it is off is led back.
  Twist solveHinges(Momentum momentum, const Eigen::Matrix3d& R,
                    const std::vector<double>& rotor_speed, double erp) const;
  /// Moves all bodies with these velocities, then gives them those.
  void move(const Twist& twist, const Eigen::Matrix3d& R, const std::vector<double>& rotor_speed);
  void setVelocities(const Twist& twist, const Eigen::Matrix3d& R,
                     const std::vector<double>& rotor_speed);
  void stepByMidpoint(const StepLoad& load, const Eigen::Matrix3d& R,
                      const std::vector<double>& rotor_speed);
  void stepByEuler(const StepLoad& load, const Eigen::Matrix3d& R,
                   const std::vector<double>& rotor_speed);
  void checkRate(const Eigen::Vector3d& w) const;
  /// How far a rotor is off its hinge [m], and its axis off the hinge's [rad], world axes.
  Eigen::Vector3d gap(const Rotor& rotor, const Eigen::Matrix3d& R) const;
  Eigen::Vector3d tilt(const Rotor& rotor, const Eigen::Matrix3d& R) const;
  Eigen::Matrix3d inertiaOf(const Rotor& rotor, const Eigen::Vector3d& axis_W) const;
  Eigen::Vector3d gyroscopicTorque(const Rotor& rotor, const Eigen::Vector3d& w_W) const;
  int collide(const Eigen::Matrix3d& R);
  void stepInContact(const StepLoad& load, const Eigen::Matrix3d& R,
                     const std::vector<double>& rotor_speed);
  void enableHinges(bool on);
  Twist twist() const;
  void checkHubs(const VehicleModel& model);
  void makeRotors(const VehicleModel& model, const WorldSettings& world);
  void makeGround(const VehicleModel& model);

  double h_, gravity_, mass_, base_mass_;
  Eigen::Vector3d com_B_;       ///< of the whole vehicle, from base_link's origin
  Eigen::Vector3d base_com_B_;  ///< of the base alone
  Eigen::Matrix3d base_inertia_;
  bool reaction_;      ///< a motor's torque acts on the base too
  bool euler_;         ///< RotorS's integrator instead of ours
  double reach_ = -1;  ///< no point of a body is farther from the base's centre of mass [m]; < 0:
                       ///< nothing can touch
  std::vector<CollisionBox> boxes_;  ///< relative to the base's centre of mass
  std::vector<Rotor> rotors_;
  Twist before_{};  ///< at the start of the last step
  Wrench ground_load_;
  std::unique_ptr<OdeWorld> ode_;
};

}  // namespace quad_sim
