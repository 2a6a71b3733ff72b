#include "simulator_world.hpp"

#include <fmt/core.h>

#include "hinged_body.hpp"
#include "option_checks.hpp"
#include "quad_support/number_format.hpp"
#include "rigid_body.hpp"

namespace quad_sim {

using Eigen::Vector3d;
using quad_support::shortest;

Simulator::World::World(const VehicleModel& m, const SimulatorOptions& o)
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

std::unique_ptr<Body> Simulator::World::makeBody() const {
  if (options.multibody == Multibody::kHinged)
    return std::make_unique<HingedBody>(model, settings, options.ground);
  return std::make_unique<RigidBody>(model, settings, options.ground);
}

void Simulator::World::restore(const VehicleState& state) {
  for (const auto& plugin : plugins) plugin->restore(state);
  placeBody(state);
}

void Simulator::World::reset(const VehicleState& state) {
  for (const auto& plugin : plugins) plugin->reset(state);
  placeBody(state);
}

void Simulator::World::placeBody(VehicleState state) {
  Vector3d momentum = Vector3d::Zero();
  for (const auto& plugin : plugins) {
    plugin->save(state);
    momentum += plugin->momentum();
  }
  body->restore(state, momentum);
  rotors_after = state;
}

void Simulator::World::forget() {
  command = start.rotor_speed;
  setWind(Vector3d::Zero());
  setPush({});
  counts = {};
  contact_step = -1;
  on_ground = false;
}

void Simulator::World::archive(StateArchive& a) {
  for (double& w : command) a(w);
  for (std::int64_t* count : {&counts.accepted, &counts.clamped, &counts.refused, &contact_step})
    a(*count);
  a(outside_wind);
  a(wind);
  windy = !air.empty() || outside_wind != Vector3d::Zero();
  a(push.force);
  a(push.torque);
  setPush(push);
  std::int64_t touching = on_ground ? 1 : 0;
  a(touching);
  on_ground = touching != 0;
  body->archive(a);
  for (const auto& plugin : plugins) plugin->archive(a);
}

std::vector<double> Simulator::World::numbers() {
  StateArchive out;
  archive(out);
  return out.numbers();
}

std::string Simulator::World::description() const {
  return fmt::format(
      "{}, {} kg, {} rotors, step {} s, gravity {} m/s^2, {}, {}, ground {}, seed {}", model.name,
      shortest(model.mass), model.rotors.size(), shortest(options.step), shortest(options.gravity),
      options.multibody == Multibody::kFolded ? "folded" : "hinged",
      options.profile == Profile::kDefault ? "default" : "rotors_compat",
      options.ground ? "on" : "off", options.seed);
}

}  // namespace quad_sim
