/// The subcommands of the program quad_experiment.
#pragma once

#include <functional>

namespace CLI {
class App;
}

/// Each adds its subcommand to `app`; `chosen` becomes what to run when it was given.
using Command = std::function<int()>;
void addRunCommand(CLI::App& app, Command& chosen);
void addCheckCommand(CLI::App& app, Command& chosen);
void addPercentilesCommand(CLI::App& app, Command& chosen);
void addStepCommand(CLI::App& app, Command& chosen);
