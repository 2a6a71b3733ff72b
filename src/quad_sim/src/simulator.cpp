#include "quad_sim/simulator.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "option_checks.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "simulator_world.hpp"

namespace quad_sim {

using Eigen::Vector3d;
using quad_support::shortest;

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

SavedState Simulator::save() const {
  return {world_->description(), world_->step_count, world_->numbers()};
}

void Simulator::restore(const SavedState& saved) {
  World& w = *world_;
  if (saved.simulator != w.description()) {
    throw quad_support::DataError(fmt::format("saved state: it is of '{}'; this simulator is '{}'",
                                              saved.simulator, w.description()));
  }
  const std::size_t expected = w.numbers().size();
  if (saved.numbers.size() != expected) {
    throw quad_support::DataError(fmt::format("saved state: {} numbers; this simulator has {}",
                                              saved.numbers.size(), expected));
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
    throw std::invalid_argument(fmt::format(
        "time_step = {} s; the present time {} s must be a whole number of it, or be reset to 0",
        shortest(step), shortest(static_cast<double>(timeNanoseconds()) / 1e9)));
  }
  changed->start = world_->start;
  changed->command = world_->command;  // as many entries as the archive hands back
  changed->step_count = timeNanoseconds() / changed->step_ns;
  StateArchive in(world_->numbers());
  changed->archive(in);
  if (changed->contact_step > 0)
    changed->contact_step = changed->contact_step * world_->step_ns / changed->step_ns;
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
  const bool sound =
      quirks.unchecked_commands || std::all_of(rotor_speeds.begin(), rotor_speeds.end(),
                                               [](double x) { return std::isfinite(x); });
  if (rotor_speeds.size() != w.command.size() || !sound) {
    ++w.counts.refused;
    throw quad_support::DataError(
        sound ? fmt::format("command: {} rotor speeds; the vehicle has {} rotors",
                            rotor_speeds.size(), w.command.size())
              : "command: a rotor speed is not a finite number");
  }
  bool clamped = false;
  for (std::size_t i = 0; i < rotor_speeds.size(); ++i) {
    const double max_speed = w.model.rotors[i].max_speed;
    w.command[i] = motorReference(rotor_speeds[i], max_speed, quirks);
    clamped = clamped || rotor_speeds[i] > max_speed ||
              (rotor_speeds[i] < 0 && !quirks.unchecked_commands);
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

void Simulator::setWind(const Vector3d& wind_W) {
  if (!wind_W.allFinite())
    throw std::invalid_argument("wind: every component must be a finite number of m/s");
  world_->setWind(wind_W);
}

void Simulator::setPush(const Wrench& push) {
  if (!push.force.allFinite() || !push.torque.allFinite()) {
    throw std::invalid_argument("push: every component must be a finite number of N or N m");
  }
  world_->setPush(push);
}

}  // namespace quad_sim
