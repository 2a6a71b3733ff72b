/// Stability of the sampled loops: exact discretisation with a late input, closed loop,
/// eigenvalues, margins.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "quad_control/pi_controller.hpp"
#include "quad_support/linear_algebra.hpp"

namespace quad_control {

/// ẋ = A x + B u, with the rows of x that the controllers measure.
struct LinearPlant {
  Eigen::MatrixXd A, B;
  std::vector<int> position;  ///< entry of x that loop i holds at zero (an angle, the altitude)
  std::vector<int> velocity;  ///< entry of x that is its derivative
};

/// The plant from one sample to the next when u[k] takes effect `latency` after sample k:
/// x[k+1] = A x[k] + B_old u[k−d−1] + B_new u[k−d] with d whole periods in the latency. Exact
/// (matrix exponentials).
struct SampledPlant {
  Eigen::MatrixXd A, B_old, B_new;
  double period = 0.0, latency = 0.0;  ///< [s]
  int whole_periods = 0;               ///< d
};

/// @param period  sampling period [s], > 0  @param latency  [s], >= 0
/// @throws std::invalid_argument for figures outside these ranges or shapes that do not fit
SampledPlant discretise(const LinearPlant& plant, double period, double latency);

/// The law of thesis section 2.2 around each of the plant's loops, gains[i] from (position,
/// velocity) i to input i.
///
/// State (x, w, u[k−1], …, u[k−d−1]) with w_i = Σ (K_I^p e^p + K_I^v e^v) dT: the two integrals act
/// as this one sum (each alone has a combination that nothing sees, an eigenvalue 1 without
/// meaning). Loops without integral gains have no w.
Eigen::MatrixXd closedLoop(const LinearPlant& plant, const SampledPlant& sampled,
                           const std::vector<PiGains>& gains);

/// Of the closed loop: below 1 means stable, its logarithm over the period is the slowest rate of
/// decay.
using quad_support::spectralRadius;

/// Robustness of one loop, broken at its input with the others closed. Gain and delay by
/// eigenvalues, so for the sampled loop as it is; phase and sensitivity by the frequency response.
struct LoopMargins {
  double gain_up = 0.0;    ///< the loop may become so many times stronger (up to 50 is looked at)
  double gain_down = 0.0;  ///< … or be scaled down to this (down to 0.02 is looked at)
  double phase_degrees = 0.0;  ///< smallest phase margin over all crossovers
  double delay_s = 0.0;        ///< so much more latency, all loops alike, is bearable [s] (up to 4
                               ///< periods are looked at)
  double sensitivity_peak = 0.0;  ///< max |1 / (1 + L)| over all frequencies
};

/// @throws std::invalid_argument if the loop as given is not stable: then there are no margins
LoopMargins margins(const LinearPlant& plant, const SampledPlant& sampled,
                    const std::vector<PiGains>& gains, int loop);

/// What the linear models below need to know of a vehicle.
struct LoopVehicle {
  double mass = 0.0;        ///< [kg]
  double inertia_xx = 0.0;  ///< roll and pitch [kg m²]
  double inertia_zz = 0.0;  ///< [kg m²]
  int num_rotors = 4;
  double thrust_coefficient = 0.0;          ///< k_f of a rotor [N/(rad/s)²]
  double drag_coefficient = 0.0;            ///< H-force of a rotor: |ω| c v_perp [N s²/(m rad)]
  double rolling_moment_coefficient = 0.0;  ///< in-plane moment of a rotor: |ω| c v_perp [N s²/rad]
  double rotor_height = 0.0;                ///< rotor plane above the centre of mass [m]
};

/// Roll and pitch of a level vehicle that climbs at `climb_rate` [m/s] (negative: falls), with its
/// horizontal motion.
///
/// Per axis: state (v, angle, rate, torque), air speed in the rotor plane s = v − ż·angle + h·rate,
/// H-force −c s, m v̇ = T·angle − c s, I·rate' = τ − h c s, τ' = (u − τ)/lag. A fall turns tilt into
/// in-plane air speed, and the H-force above the centre of mass into a pendulum of stiffness h c
/// |ż|. `rolling_moments_add` takes RotorS's sign error (moments of all rotors add up), which
/// couples the axes: with it one plant of two loops, eight states; without, four states and one
/// loop that stand for either axis.
LinearPlant tiltPlant(const LoopVehicle& vehicle, double climb_rate, double rotor_speed, double lag,
                      bool rolling_moments_add = false);

/// One double integrator with rotor lag: state (position, velocity, effort), inertia·velocity' =
/// effort. Yaw with inertia_zz, altitude with the mass.
LinearPlant doubleIntegratorPlant(double inertia, double lag);

}  // namespace quad_control
