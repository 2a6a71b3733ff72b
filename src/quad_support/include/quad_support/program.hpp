/// The frame of every main(): exceptions become one line on stderr and an exit code.
#pragma once

#include <functional>
#include <string>

namespace quad_support {

/// Sets the "C" locale, installs the interrupt handlers, runs `body` and returns its exit code. An
/// exception ends in one line `name: text` on stderr and the exit code of its class (see
/// errors.hpp): std::invalid_argument 2, SimulationError 4, NegativeAnswer 3, Interrupted 128 +
/// signal, anything else 5. So does, with 5, a standard output that cannot be written.
/// @param message  if given, receives that text (empty without an exception)
int runProgram(const std::string& name, const std::function<int()>& body,
               std::string* message = nullptr);

/// Writes `text` to stdout, now. @param kept  where it can be read otherwise, for the complaint:
/// "the results stand in D"
/// @throws EnvironmentError if stdout cannot be written
void print(const std::string& text, const std::string& kept);

}  // namespace quad_support
