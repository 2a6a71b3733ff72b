#include "wind_plugin.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace quad_sim {
namespace {

using Eigen::Vector3d;

constexpr const char* kFilename = "librotors_gazebo_wind_plugin.so";

const PluginDeclaration& onlyDeclaration(const VehicleModel& model) {
  const PluginDeclaration* found = nullptr;
  for (const PluginDeclaration& p : model.plugins) {
    if (p.filename != kFilename) continue;
    if (found) p.fail("linkName", "is of a second wind plugin; a vehicle has one wind");
    found = &p;
  }
  return *found;
}

double notNegative(const PluginDeclaration& p, const std::string& tag, double fallback) {
  const double value = p.number(tag, fallback);
  if (value < 0) p.fail(tag, "must be >= 0");
  return value;
}

Vector3d direction(const PluginDeclaration& p, const std::string& tag, const Vector3d& fallback) {
  const Vector3d v = p.vector(tag, fallback);
  if (!(v.norm() > 0) || !std::isfinite(v.norm()))
    p.fail(tag, "must point somewhere: three numbers, not all zero");
  return v.normalized();
}

}  // namespace

WindSettings::WindSettings(const PluginDeclaration& p)
    : offset_B(p.vector("xyzOffset", Vector3d::Zero())),
      direction_W(direction(p, "windDirection", Vector3d::UnitX())),
      gust_direction_W(direction(p, "windGustDirection", Vector3d::UnitY())),
      force(p.number("windForceMean", 0.0)),
      force_amplitude(p.number("windForceAmplitude", 0.0)),
      gust_force(p.number("windGustForceMean", 0.0)),
      gust_start(p.number("windGustStart", 10.0)),
      gust_duration(notNegative(p, "windGustDuration", 0.0)),
      speed(p.number("windSpeedMean", 0.0)),
      speed_amplitude(p.number("windSpeedAmplitude", 0.0)),
      frequency(notNegative(p, "windFrequency", 0.0)),
      phase(p.number("windPhase", 0.0)) {
  const std::string field = p.text("useCustomStaticWindField", "false");
  if (field != "false" && field != "0")
    p.fail("useCustomStaticWindField", "must be false: wind fields from a file are not modelled");
}

WindPlugin::WindPlugin(const VehicleModel& model, const WorldSettings& world)
    : settings_(onlyDeclaration(model)),
      arm_C_(settings_.offset_B - model.com_B),
      turbulence_(TurbulenceSettings(onlyDeclaration(model), settings_.speed),
                  settings_.direction_W, world),
      moves_air_(settings_.speed != 0 || settings_.speed_amplitude != 0 || turbulence_.blows()),
      step_(world.step) {}

double WindPlugin::sine(double time) const {
  constexpr double kTurn = 6.283185307179586;
  return std::sin(kTurn * settings_.frequency * time + settings_.phase);
}

void WindPlugin::addWind(const StepInput& input, Vector3d& wind_W) {
  wind_W +=
      (settings_.speed + settings_.speed_amplitude * sine(input.time)) * settings_.direction_W;
  if (turbulence_.blows()) wind_W += turbulence_.next(input.step);
}

void WindPlugin::step(const StepInput& input, StepLoad& load) {
  force_W_ =
      (settings_.force + settings_.force_amplitude * sine(input.time)) * settings_.direction_W;
  // The share of this step that the gust covers: its impulse is force times duration, whatever the
  // step.
  const double from = std::max(input.time, settings_.gust_start);
  const double to = std::min(input.time + step_, settings_.gust_start + settings_.gust_duration);
  if (to > from)
    force_W_ +=
        settings_.gust_force * std::min(1.0, (to - from) / step_) * settings_.gust_direction_W;
  if (force_W_ == Vector3d::Zero()) return;
  const Vector3d force_B = input.R_WB.transpose() * force_W_;
  load.force_B += force_B;
  load.torque_B += arm_C_.cross(force_B);
}

void WindPlugin::restore(const VehicleState&) {
  turbulence_.restart();
  force_W_.setZero();
}

void WindPlugin::archive(StateArchive& archive) {
  archive(force_W_);
  turbulence_.archive(archive);
}

}  // namespace quad_sim
