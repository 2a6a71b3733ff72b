#include <cstdio>

#include "commands.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

void writeAnswer(const std::string& path, const std::string& text) {
  if (!path.empty()) return quad_support::writeFileAtomically(path, text);
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw quad_support::EnvironmentError("cannot write the answer to standard output");
}

}  // namespace explore_opt
