/// The complete state of a world as text, and back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "vehicle.hpp"

namespace quad_sim {

/// Of each vehicle its name, its simulator's state and that of its sensors.
std::string saveWorld(const std::vector<std::unique_ptr<Vehicle>>& vehicles);

/// @throws quad_support::DataError if the text is not of such vehicles; nothing has changed then
void restoreWorld(const std::vector<std::unique_ptr<Vehicle>>& vehicles, const std::string& text);

}  // namespace quad_sim
