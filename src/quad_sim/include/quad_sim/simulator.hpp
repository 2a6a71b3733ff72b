/// The plant: a vehicle, its plugins and a rigid-body world, moved in fixed steps of integer time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "quad_sim/imu_sensor.hpp"
#include "quad_sim/quirks.hpp"
#include "quad_sim/state.hpp"
#include "quad_sim/state_archive.hpp"
#include "quad_sim/vehicle_model.hpp"

namespace quad_sim {

enum class Multibody { kFolded, kHinged };  ///< rotors folded into one body, or bodies of their own
enum class Profile { kDefault, kRotorsCompat };  ///< correct physics, or RotorS with its quirks

struct SimulatorOptions {
  double step = 0.001;   ///< physics step [s], a whole number of nanoseconds
  double gravity = 9.8;  ///< along -z [m/s²], >= 0
  Multibody multibody = Multibody::kFolded;
  Profile profile = Profile::kDefault;
  bool ground = true;      ///< contact plane at z = 0
  std::uint64_t seed = 0;  ///< of sensors' noise and turbulence
  RotorsQuirks quirks;     ///< further quirks on top of the profile's

  /// Those in force: all of them with rotors_compat.
  RotorsQuirks allQuirks() const {
    return profile == Profile::kRotorsCompat ? RotorsQuirks::all() : quirks;
  }
};

/// Commands setCommand() did not take as they were, since reset.
struct CommandCounts {
  std::int64_t accepted = 0;
  std::int64_t clamped = 0;  ///< some speed was negative or above the rotor's maximum
  std::int64_t refused = 0;  ///< wrong length or not a number: the earlier command stays
};

/// One vehicle in a world of its own. Deterministic: the same calls after reset() give the same
/// bits. One thread at a time; several simulators may live in several threads.
class Simulator {
 public:
  /// Starts at rest at the origin, level, on the ground (at the lowest box's rest height if there
  /// is one), rotors still.
  /// @throws std::invalid_argument naming the option, value and limit; also for modes this version
  /// does not have
  Simulator(const VehicleModel& model, const SimulatorOptions& options);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  const VehicleModel& model() const;
  const SimulatorOptions& options() const;

  /// Sets the state reset() goes back to, and goes there (time 0). The command becomes the state's
  /// rotor speeds.
  /// @throws std::invalid_argument: not finite, wrong number of rotors, speed outside [0, max],
  /// zero quaternion
  void setStartState(const VehicleState& state);
  void reset();       ///< everything as at the start: state, command, counts, time
  void resetWorld();  ///< the same, but time goes on
  /// Puts the vehicle into another state; time, command and counts stay. @throws as setStartState()
  void setState(const VehicleState& state);

  /// Everything that what comes next depends on: body, rotors, other plugins, command, counts,
  /// time. The start state is not part of it.
  SavedState save() const;
  /// Continues bit for bit where `saved` was taken, in this or in another process.
  /// @throws quad_support::DataError if it is of another vehicle or of other options; nothing has
  /// changed then
  void restore(const SavedState& saved);
  /// Changes the physics step [s] and gravity [m/s²] in flight. @throws std::invalid_argument as
  /// the constructor, or if the present time is no whole number of the new step; nothing has
  /// changed then
  void setPhysics(double step, double gravity);

  /// Rotor speeds [rad/s], unsigned, by motor number, held from now on; clamped to [0, max_speed]
  /// and counted if so.
  /// @throws quad_support::DataError for a wrong length or a value that is not finite; the earlier
  /// command stays
  void setCommand(const std::vector<double>& rotor_speeds);
  const std::vector<double>& command() const;
  const CommandCounts& commandCounts() const;

  /// Moves time by `steps` physics steps (>= 0). Allocates nothing.
  /// @throws quad_support::SimulationError if the state is no longer finite
  void advance(int steps);

  std::int64_t stepCount() const;        ///< since reset()
  std::int64_t stepNanoseconds() const;  ///< length of a step
  std::int64_t timeNanoseconds() const;  ///< stepCount() * stepNanoseconds()
  VehicleState state() const;
  Measurement measure() const;  ///< ideal odometry of base_link's origin, and the rotor speeds
  void measure(
      Measurement& out) const;  ///< the same into an existing one: no allocation after the first
  Odometry odometry(const SensorModel& sensor) const;  ///< ideal odometry of a sensor's frame
  /// What an ideal accelerometer at the sensor's place feels [m/s²], sensor's axes: acceleration
  /// less gravity, its mean over the last physics step; at rest after reset() or setState() before
  /// a step, that is g upwards.
  Eigen::Vector3d specificForce(const SensorModel& sensor) const;

  /// A wind from outside [m/s], world axes, on top of the wind plugin's, held until the next; zero
  /// after reset(). @throws if not finite
  void setWind(const Eigen::Vector3d& wind_W);
  /// Force of the wind plugin and the like during the last step [N], world axes.
  Eigen::Vector3d outsideForce() const;
  /// A push from outside, held until the next; zero after reset(). Its axes are the world's,
  /// however the vehicle turns. @throws if not finite
  void setPush(const Wrench& push);
  /// What the ground put on the vehicle during the last step, of all contacts together; zero in the
  /// air.
  Wrench groundLoad() const;
  Eigen::Vector3d wind() const;  ///< of the last step, all shares together [m/s], world axes

  /// Noise-free reading of an IMU: attitude and rate now, and specificForce().
  ImuReading imu(const SensorModel& sensor) const;

  /// The rotors' own bodies; empty unless hinged.
  std::vector<RotorState> rotorStates() const;
  /// Motor numbers of rotors that turn more than half a turn in a physics step: what looks at them
  /// step by step sees them turn slowly or backwards.
  std::vector<int> aliasedRotors() const;

  bool groundContact() const;  ///< the vehicle has touched the ground since reset
  std::optional<std::int64_t> groundContactTime() const;  ///< first contact since reset [ns]

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace quad_sim
