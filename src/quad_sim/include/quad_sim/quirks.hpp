/// RotorS's peculiarities, each a switch of its own. All off is the physics as it should be.
#pragma once

#include <string>
#include <vector>

namespace quad_sim {

/// Each switch makes one thing as RotorS does it. The profile rotors_compat is all of them.
struct RotorsQuirks {
  bool thrust_lag =
      false;  ///< forces come from the speed of the step before: the motor's filter runs after them
  bool unchecked_commands =
      false;  ///< only the upper limit is enforced: negative commands and NaN reach the motors
  bool float_commands =
      false;  ///< commands are rounded to single precision on their way to the motors
  bool rolling_moment_sign =
      false;  ///< the rolling moment lacks the turning direction: it adds up over balanced rotors
  bool no_spin_reaction = false;    ///< speeding a rotor up does not turn the body back
  bool urdf_rotor_inertia = false;  ///< rotors weigh in with the URDF's inertia, `slowdown` times
                                    ///< the physical one; none about the axis
  bool euler_integration =
      false;  ///< semi-implicit Euler with the gyroscopic torque at the start of the step
  bool filter_survives_reset = false;  ///< reset() leaves the motors' filters as they are, and
                                       ///< their first step then has dt < 0
  bool world_reset_keeps_rotors =
      false;  ///< resetWorld() resets poses and velocities only: rotors and commands go on
  bool stamp_ahead = false;  ///< measurements carry the time of the step after the one they show
  bool sensor_reports =
      false;  ///< sensors' covariances, tags and stamps as RotorS's plugins have them
  bool aliasing_blind = false;  ///< the warning of aliasing looks at the slowed, signed speed:
                                ///< never for clockwise rotors

  static RotorsQuirks all();
  static RotorsQuirks none() { return {}; }
  /// The switch of that name, e.g. "thrust_lag". @throws std::invalid_argument listing the names
  bool& byName(const std::string& name);
  static std::vector<std::string> names();
};

}  // namespace quad_sim
