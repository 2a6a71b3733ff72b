#include "option_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "quad_support/number_format.hpp"

namespace quad_sim {

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
  if (options.gravity >= 0 && std::isfinite(options.gravity)) return;
  throw std::invalid_argument(
      fmt::format("simulation.gravity = {} m/s^2; must be {}>= 0", shortest(options.gravity),
                  std::isfinite(options.gravity) ? "" : "a finite number "));
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

VehicleState restState(const VehicleModel& model) {
  VehicleState state;
  state.rotor_speed.assign(model.rotors.size(), 0.0);
  for (const CollisionBox& box : model.boxes) {
    const double half_height = 0.5 * box.X_BC.linear().row(2).cwiseAbs().dot(box.size);
    state.p_WB.z() = std::max(state.p_WB.z(), half_height - box.X_BC.translation().z());
  }
  return state;
}

}  // namespace quad_sim
