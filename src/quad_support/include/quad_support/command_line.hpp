/// What the programs' command lines have in common.
#pragma once

#include <string>
#include <vector>

namespace quad_support {

/// Of the workspace, for --version and provenance.
extern const char* const kVersion;

/// What is wrong with a command line, in a line: a first word that is no command is answered with
/// those there are, anything else with `problem`; then where to read more.
/// @param problem  as the parser puts it
std::string argumentProblem(const std::string& program, const std::string& problem,
                            const std::vector<std::string>& commands, int argc,
                            const char* const* argv);

}  // namespace quad_support
