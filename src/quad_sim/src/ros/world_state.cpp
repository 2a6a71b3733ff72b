#include "world_state.hpp"

#include <sstream>
#include <stdexcept>

#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

SavedState sensorsOf(Vehicle& vehicle) {
  StateArchive out;
  vehicle.archive(out);
  return {"sensors", vehicle.simulator.stepCount(), out.numbers()};
}

/// The four lines of one toText().
std::string fourLines(std::istream& in) {
  std::string text, line;
  for (int i = 0; i < 4 && std::getline(in, line); ++i) text += line + "\n";
  return text;
}

void restoreVehicle(Vehicle& vehicle, std::istream& in) {
  std::string line;
  if (!std::getline(in, line) || line != "vehicle " + vehicle.name) {
    throw quad_support::DataError("saved state: '" + line + "' where 'vehicle " + vehicle.name +
                                  "' should be; this world has other vehicles");
  }
  vehicle.simulator.restore(savedStateFromText(fourLines(in)));
  StateArchive sensors(savedStateFromText(fourLines(in)).numbers);
  try {
    vehicle.archive(sensors);
  } catch (const std::exception&) {
    throw quad_support::DataError("saved state: the sensors of " + vehicle.name + " are others");
  }
}

void restoreAll(const std::vector<std::unique_ptr<Vehicle>>& vehicles, const std::string& text) {
  std::istringstream in(text);
  for (const auto& vehicle : vehicles) restoreVehicle(*vehicle, in);
  std::string rest;
  if (std::getline(in, rest))
    throw quad_support::DataError("saved state: '" + rest +
                                  "' behind its end; this world has fewer vehicles");
  for (const auto& vehicle : vehicles) {
    if (vehicle->simulator.stepCount() != vehicles.front()->simulator.stepCount()) {
      throw quad_support::DataError("saved state: its vehicles are not of the same step");
    }
  }
}

}  // namespace

std::string saveWorld(const std::vector<std::unique_ptr<Vehicle>>& vehicles) {
  std::string text;
  for (const auto& vehicle : vehicles) {
    text += "vehicle " + vehicle->name + "\n" + toText(vehicle->simulator.save()) +
            toText(sensorsOf(*vehicle));
  }
  return text;
}

void restoreWorld(const std::vector<std::unique_ptr<Vehicle>>& vehicles, const std::string& text) {
  const std::string before = saveWorld(vehicles);
  try {
    restoreAll(vehicles, text);
  } catch (...) {
    restoreAll(vehicles, before);
    throw;
  }
}

}  // namespace quad_sim
