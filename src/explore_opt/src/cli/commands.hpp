/// The subcommands of the program; each adds its options and returns what to do if it was chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace explore_opt {

using Action = std::function<int()>;  ///< exit code, see quad_support/errors.hpp

Action addAuditCommand(CLI::App& app);
Action addBaselinesCommand(CLI::App& app);
Action addDesignCommand(CLI::App& app);
Action addFrequenciesCommand(CLI::App& app);
Action addIdentifyCommand(CLI::App& app);
Action addPredictCommand(CLI::App& app);
Action addReplayCommand(CLI::App& app);

/// To a file in one piece, or to stdout if `path` is empty. @throws quad_support::EnvironmentError
void writeAnswer(const std::string& path, const std::string& text);

}  // namespace explore_opt
