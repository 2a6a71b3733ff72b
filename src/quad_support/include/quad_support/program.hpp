/// The frame of every main(): exceptions become one line on stderr and an exit code.
#pragma once

#include <functional>
#include <string>

namespace quad_support {

/// Sets the "C" locale, installs the interrupt handlers, runs `body` and returns its exit code. An
/// exception ends in one line `name: text` on stderr and the exit code of its class (see
/// errors.hpp): std::invalid_argument 2, SimulationError 4, NegativeAnswer 3, Interrupted 128 +
/// signal, anything else 5.
/// @param message  if given, receives that text (empty without an exception)
int runProgram(const std::string& name, const std::function<int()>& body,
               std::string* message = nullptr);

}  // namespace quad_support
