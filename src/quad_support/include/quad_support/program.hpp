/// The frame of every main(): exceptions become one line on stderr and an exit code.
#pragma once

#include <functional>
#include <string>

namespace quad_support {

/// Sets the "C" locale, installs the interrupt handlers, runs `body` and returns its exit code. An exception ends
/// in one line `name: text` on stderr and the exit code of its class (see errors.hpp): std::invalid_argument 2,
/// SimulationError 4, Interrupted 128 + signal, anything else 5.
int runProgram(const std::string& name, const std::function<int()>& body);

}  // namespace quad_support
