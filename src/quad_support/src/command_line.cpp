#include "quad_support/command_line.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "near_name.hpp"

namespace quad_support {

const char* const kVersion = QUAD_VERSION;

std::string argumentProblem(const std::string& program, const std::string& problem,
                            const std::vector<std::string>& commands, int argc,
                            const char* const* argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  const bool command = first.empty() || first[0] == '-' ||
                       std::find(commands.begin(), commands.end(), first) != commands.end();
  if (command) return fmt::format("{} ({} --help tells more)", problem, program);
  const std::string near = nearName(first, commands);
  return fmt::format("{}: no such command{}; known: {} ({} --help tells more)", first,
                     near.empty() ? "" : fmt::format(", did you mean {}?", near),
                     fmt::join(commands, ", "), program);
}

}  // namespace quad_support
