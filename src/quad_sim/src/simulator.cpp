#include "quad_sim/simulator.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "quad_sim/plugin.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "hinged_body.hpp"
#include "rigid_body.hpp"

namespace quad_sim {
namespace {

using Eigen::Vector3d;
using quad_support::shortest;

std::int64_t wholeNanoseconds(double seconds) {
  constexpr double kMaxStep = 1.0;  // [s]; slower than any rotor or attitude motion by far
  const double ns = seconds * 1e9;
  const double whole = std::round(ns);
  // A decimal text such as 0.001 is off by up to 1e-16 relative; anything more is not what was
  // meant.
  if (!(seconds > 0) || seconds > kMaxStep || std::abs(ns - whole) > 1e-6 || whole < 1) {
    throw std::invalid_argument(
        fmt::format("simulation.step = {} s; must be a whole number of nanoseconds in (0, {}] s",
                    shortest(seconds), shortest(kMaxStep)));
  }
  return static_cast<std::int64_t>(whole);
}

void check(const SimulatorOptions& options) {
  if (!(options.gravity >= 0) || !std::isfinite(options.gravity)) {
    throw std::invalid_argument(
        fmt::format("simulation.gravity = {} m/s^2; must be >= 0", shortest(options.gravity)));
  }
}

void check(const VehicleState& state, const VehicleModel& model) {
  if (!state.p_WB.allFinite() || !state.v_WB.allFinite() || !state.w_WB_B.allFinite() ||
      !state.q_WB.coeffs().allFinite()) {
    throw std::invalid_argument("vehicle state: every number must be finite");
  }
  if (!(state.q_WB.norm() > 1e-6))
    throw std::invalid_argument("vehicle state: the quaternion must not be zero");
  if (state.rotor_speed.size() != model.rotors.size()) {
    throw std::invalid_argument(
        fmt::format("vehicle state: {} rotor speeds; the vehicle has {} rotors",
                    state.rotor_speed.size(), model.rotors.size()));
  }
  for (std::size_t i = 0; i < model.rotors.size(); ++i) {
    const double w = state.rotor_speed[i];
    if (!(w >= 0) || w > model.rotors[i].max_speed) {
      throw std::invalid_argument(
          fmt::format("vehicle state: rotor_speed[{}] = {} rad/s; must lie in [0, {}]", i,
                      shortest(w), shortest(model.rotors[i].max_speed)));
    }
  }
}

/// Level, on the ground, rotors still.
VehicleState restState(const VehicleModel& model) {
  VehicleState state;
  state.rotor_speed.assign(model.rotors.size(), 0.0);
  for (const CollisionBox& box : model.boxes) {
    const double half_height = 0.5 * box.X_BC.linear().row(2).cwiseAbs().dot(box.size);
    state.p_WB.z() = std::max(state.p_WB.z(), half_height - box.X_BC.translation().z());
  }
  return state;
}

}  // namespace

struct Simulator::World {
  World(const VehicleModel& m, const SimulatorOptions& o)
      : model(m),
        options((check(o), o)),
        step_ns(wholeNanoseconds(o.step)),
        settings{static_cast<double>(step_ns) * 1e-9, o.gravity, o.seed, o.allQuirks()},
        plugins(makePlugins(m, settings)),
        body(makeBody()) {
    for (const auto& plugin : plugins) {
      if (plugin->movesAir()) air.push_back(plugin.get());
    }
    setWind(Vector3d::Zero());
  }

  std::unique_ptr<Body> makeBody() const {
    if (options.multibody == Multibody::kHinged) return std::make_unique<HingedBody>(model, settings, options.ground);
    return std::make_unique<RigidBody>(model, settings, options.ground);
  }

  void restore(const VehicleState& state) {
    for (const auto& plugin : plugins) plugin->restore(state);
    placeBody(state);
  }

  void reset(const VehicleState& state) {
    for (const auto& plugin : plugins) plugin->reset(state);
    placeBody(state);
  }

  /// The body into that state, the rotors turning as they do.
  void placeBody(VehicleState state) {
    Vector3d momentum = Vector3d::Zero();
    for (const auto& plugin : plugins) {
      plugin->save(state);
      momentum += plugin->momentum();
    }
    body->restore(state, momentum);
    rotors_after = state;
  }

  /// Everything but the plant's state as at the start.
  void forget() {
    command = start.rotor_speed;
    setWind(Vector3d::Zero());
    counts = {};
    contact_step = -1;
  }

  void archive(StateArchive& a) {
    for (double& w : command) a(w);
    for (std::int64_t* count : {&counts.accepted, &counts.clamped, &counts.refused, &contact_step}) a(*count);
    a(outside_wind);
    a(wind);
    windy = !air.empty() || outside_wind != Vector3d::Zero();
    body->archive(a);
    for (const auto& plugin : plugins) plugin->archive(a);
  }

  std::vector<double> numbers() {
    StateArchive out;
    archive(out);
    return out.numbers();
  }

  /// What a saved state must come from to fit.
  std::string description() const {
    return fmt::format("{}, {} kg, {} rotors, step {} s, gravity {} m/s^2, {}, {}, ground {}, seed {}", model.name, shortest(model.mass),
                       model.rotors.size(), shortest(options.step), shortest(options.gravity),
                       options.multibody == Multibody::kFolded ? "folded" : "hinged",
                       options.profile == Profile::kDefault ? "default" : "rotors_compat", options.ground ? "on" : "off", options.seed);
  }

  void step() {
    StepInput input;
    body->motion(input);
    input.command = command.data();
    input.step = step_count;
    input.time = static_cast<double>(step_count * step_ns) * 1e-9;
    if (windy) blow(input);
    StepLoad load{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
    for (const auto& plugin : plugins) plugin->step(input, load);
    if (options.multibody == Multibody::kHinged) {
      for (const auto& plugin : plugins) plugin->save(rotors_after);
    }
    if (body->step(load, rotors_after.rotor_speed) && contact_step < 0) contact_step = step_count + 1;
    ++step_count;
  }

  /// From here on the plugins see the motion through the air.
  void blow(StepInput& input) {
    wind = outside_wind;
    for (Plugin* plugin : air) plugin->addWind(input, wind);
    input.v_WC_B -= input.R_WB.transpose() * wind;
  }

  void setWind(const Vector3d& wind_W) {
    outside_wind = wind = wind_W;
    windy = !air.empty() || wind_W != Vector3d::Zero();
  }

  VehicleModel model;
  SimulatorOptions options;
  std::int64_t step_ns;
  WorldSettings settings;
  std::vector<std::unique_ptr<Plugin>> plugins;
  std::vector<Plugin*> air;  ///< those that move it
  Vector3d outside_wind = Vector3d::Zero(), wind = Vector3d::Zero();
  bool windy = false;
  std::unique_ptr<Body> body;
  VehicleState rotors_after;  ///< only the rotors' part of it: at the end of the step, for the hinges
  VehicleState start;
  std::vector<double> command;
  CommandCounts counts;
  std::int64_t step_count = 0;
  std::int64_t contact_step = -1;
};

Simulator::Simulator(const VehicleModel& model, const SimulatorOptions& options)
    : world_(std::make_unique<World>(model, options)) {
  setStartState(restState(model));
}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

const VehicleModel& Simulator::model() const { return world_->model; }
const SimulatorOptions& Simulator::options() const { return world_->options; }

void Simulator::setStartState(const VehicleState& state) {
  check(state, world_->model);
  World& w = *world_;
  w.start = state;
  w.forget();
  w.step_count = 0;
  w.restore(w.start);
}

void Simulator::reset() {
  World& w = *world_;
  w.forget();
  w.step_count = 0;
  w.reset(w.start);
}

void Simulator::resetWorld() {
  World& w = *world_;
  if (w.settings.quirks.world_reset_keeps_rotors) {
    w.contact_step = -1;
    return w.placeBody(w.start);
  }
  w.forget();
  w.reset(w.start);
}

void Simulator::setState(const VehicleState& state) {
  check(state, world_->model);
  world_->restore(state);
}

SavedState Simulator::save() const { return {world_->description(), world_->step_count, world_->numbers()}; }

void Simulator::restore(const SavedState& saved) {
  World& w = *world_;
  if (saved.simulator != w.description()) {
    throw quad_support::DataError(fmt::format("saved state: it is of '{}'; this simulator is '{}'", saved.simulator, w.description()));
  }
  const std::size_t expected = w.numbers().size();
  if (saved.numbers.size() != expected) {
    throw quad_support::DataError(fmt::format("saved state: {} numbers; this simulator has {}", saved.numbers.size(), expected));
  }
  StateArchive in(saved.numbers);
  w.archive(in);
  w.step_count = saved.step_count;
}

void Simulator::setPhysics(double step, double gravity) {
  SimulatorOptions options = world_->options;
  options.step = step;
  options.gravity = gravity;
  auto changed = std::make_unique<World>(world_->model, options);
  if (timeNanoseconds() % changed->step_ns != 0) {
    throw std::invalid_argument(fmt::format("time_step = {} s; the present time {} s must be a whole number of it, or be reset to 0",
                                            shortest(step), shortest(static_cast<double>(timeNanoseconds()) / 1e9)));
  }
  changed->start = world_->start;
  changed->command = world_->command;  // as many entries as the archive hands back
  changed->step_count = timeNanoseconds() / changed->step_ns;
  StateArchive in(world_->numbers());
  changed->archive(in);
  if (changed->contact_step > 0) changed->contact_step = changed->contact_step * world_->step_ns / changed->step_ns;
  world_ = std::move(changed);
}

namespace {

/// What the motors are told of a commanded speed.
double motorReference(double speed, double max_speed, const RotorsQuirks& quirks) {
  if (quirks.float_commands) speed = static_cast<double>(static_cast<float>(speed));
  if (quirks.unchecked_commands) return speed > max_speed ? max_speed : speed;  // NaN stays NaN
  return std::clamp(speed, 0.0, max_speed);
}

}  // namespace

void Simulator::setCommand(const std::vector<double>& rotor_speeds) {
  World& w = *world_;
  const RotorsQuirks& quirks = w.settings.quirks;
  const bool sound = quirks.unchecked_commands || std::all_of(rotor_speeds.begin(), rotor_speeds.end(),
                                                              [](double x) { return std::isfinite(x); });
  if (rotor_speeds.size() != w.command.size() || !sound) {
    ++w.counts.refused;
    throw quad_support::DataError(sound ? fmt::format("command: {} rotor speeds; the vehicle has {} rotors", rotor_speeds.size(),
                                                      w.command.size())
                                        : "command: a rotor speed is not a finite number");
  }
  bool clamped = false;
  for (std::size_t i = 0; i < rotor_speeds.size(); ++i) {
    const double max_speed = w.model.rotors[i].max_speed;
    w.command[i] = motorReference(rotor_speeds[i], max_speed, quirks);
    clamped = clamped || rotor_speeds[i] > max_speed || (rotor_speeds[i] < 0 && !quirks.unchecked_commands);
  }
  ++w.counts.accepted;
  w.counts.clamped += clamped ? 1 : 0;
}

const std::vector<double>& Simulator::command() const { return world_->command; }
const CommandCounts& Simulator::commandCounts() const { return world_->counts; }

void Simulator::advance(int steps) {
  if (steps < 0) throw std::invalid_argument(fmt::format("advance: {} steps; must be >= 0", steps));
  std::string problem;
  try {
    for (int i = 0; i < steps; ++i) world_->step();
    if (world_->body->isFinite()) return;
    problem = "the state is no longer finite";
  } catch (const quad_support::SimulationError& e) {
    problem = e.what();
  }
  throw quad_support::SimulationError(
      fmt::format("diverged: {} at {} s of simulated time", problem,
                  shortest(static_cast<double>(timeNanoseconds()) / 1e9)));
}

std::int64_t Simulator::stepCount() const { return world_->step_count; }
std::int64_t Simulator::stepNanoseconds() const { return world_->step_ns; }
std::int64_t Simulator::timeNanoseconds() const { return world_->step_count * world_->step_ns; }

VehicleState Simulator::state() const {
  VehicleState state;
  world_->body->save(state);
  for (const auto& plugin : world_->plugins) plugin->save(state);
  return state;
}

void Simulator::measure(Measurement& out) const {
  VehicleState state;
  state.rotor_speed.swap(out.rotor_speed);
  world_->body->save(state);
  for (const auto& plugin : world_->plugins) plugin->save(state);
  out.rotor_speed.swap(state.rotor_speed);
  // RotorS samples at the start of a step whose time it has advanced already.
  out.odometry.time_ns = timeNanoseconds() + (world_->settings.quirks.stamp_ahead ? stepNanoseconds() : 0);
  out.odometry.p_WB = state.p_WB;
  out.odometry.q_WB = state.q_WB;
  out.odometry.v_WB_B = state.q_WB.conjugate() * state.v_WB;
  out.odometry.w_WB_B = state.w_WB_B;
  out.ground_contact_ns = groundContactTime();
}

Measurement Simulator::measure() const {
  Measurement measurement;
  measure(measurement);
  return measurement;
}

Odometry Simulator::odometry(const SensorModel& sensor) const {
  Odometry at = measure().odometry;
  if (sensor.X_BS.isApprox(Eigen::Isometry3d::Identity(), 0.0))
    return at;  // the very bits of measure()
  const Vector3d r_B = sensor.X_BS.translation();
  const Eigen::Quaterniond q_BS(sensor.X_BS.linear());
  at.p_WB += at.q_WB * r_B;
  at.v_WB_B = q_BS.conjugate() * (at.v_WB_B + at.w_WB_B.cross(r_B));
  at.w_WB_B = q_BS.conjugate() * at.w_WB_B;
  at.q_WB = (at.q_WB * q_BS).normalized();
  return at;
}

Vector3d Simulator::specificForce(const SensorModel& sensor) const {
  const Vector3d r_C = sensor.X_BS.translation() - world_->model.com_B;
  return sensor.X_BS.linear().transpose() * world_->body->specificForce(r_C);
}

void Simulator::setWind(const Vector3d& wind_W) {
  if (!wind_W.allFinite())
    throw std::invalid_argument("wind: every component must be a finite number of m/s");
  world_->setWind(wind_W);
}

Vector3d Simulator::outsideForce() const {
  Vector3d sum = Vector3d::Zero();
  for (const auto& plugin : world_->plugins) sum += plugin->outsideForce();
  return sum;
}

std::vector<RotorState> Simulator::rotorStates() const { return world_->body->rotors(); }

std::vector<int> Simulator::aliasedRotors() const {
  const VehicleState now = state();
  const World& w = *world_;
  std::vector<int> numbers;
  for (const RotorModel& rotor : w.model.rotors) {
    const double speed = now.rotor_speed[static_cast<std::size_t>(rotor.motor_number)];
    const double seen = w.settings.quirks.aliasing_blind ? rotor.spin * speed / rotor.slowdown : std::abs(speed);
    constexpr double kHalfTurn = 3.141592653589793;  // [rad]
    if (seen * w.settings.step > kHalfTurn) numbers.push_back(rotor.motor_number);
  }
  return numbers;
}

Vector3d Simulator::wind() const { return world_->wind; }

ImuReading Simulator::imu(const SensorModel& sensor) const {
  const Odometry at = odometry(sensor);
  return {at.time_ns, at.q_WB, at.w_WB_B, specificForce(sensor)};
}

bool Simulator::groundContact() const { return world_->contact_step >= 0; }

std::optional<std::int64_t> Simulator::groundContactTime() const {
  if (!groundContact()) return std::nullopt;
  return world_->contact_step * world_->step_ns;
}

}  // namespace quad_sim
