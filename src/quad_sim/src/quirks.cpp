#include "quad_sim/quirks.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace quad_sim {
namespace {

using Switch = std::pair<const char*, bool RotorsQuirks::*>;
constexpr std::array<Switch, 12> kSwitches = {{
    {"thrust_lag", &RotorsQuirks::thrust_lag},
    {"unchecked_commands", &RotorsQuirks::unchecked_commands},
    {"float_commands", &RotorsQuirks::float_commands},
    {"rolling_moment_sign", &RotorsQuirks::rolling_moment_sign},
    {"no_spin_reaction", &RotorsQuirks::no_spin_reaction},
    {"urdf_rotor_inertia", &RotorsQuirks::urdf_rotor_inertia},
    {"euler_integration", &RotorsQuirks::euler_integration},
    {"filter_survives_reset", &RotorsQuirks::filter_survives_reset},
    {"world_reset_keeps_rotors", &RotorsQuirks::world_reset_keeps_rotors},
    {"stamp_ahead", &RotorsQuirks::stamp_ahead},
    {"sensor_reports", &RotorsQuirks::sensor_reports},
    {"aliasing_blind", &RotorsQuirks::aliasing_blind},
}};
static_assert(sizeof(RotorsQuirks) == kSwitches.size() * sizeof(bool), "every switch has a name");

}  // namespace

RotorsQuirks RotorsQuirks::all() {
  RotorsQuirks quirks;
  for (const Switch& s : kSwitches) quirks.*s.second = true;
  return quirks;
}

bool& RotorsQuirks::byName(const std::string& name) {
  for (const Switch& s : kSwitches) {
    if (name == s.first) return this->*s.second;
  }
  throw std::invalid_argument(fmt::format("{}; must be one of {}", name, fmt::join(names(), ", ")));
}

std::vector<std::string> RotorsQuirks::names() {
  std::vector<std::string> all;
  for (const Switch& s : kSwitches) all.emplace_back(s.first);
  return all;
}

}  // namespace quad_sim
