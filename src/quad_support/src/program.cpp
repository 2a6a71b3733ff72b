#include "quad_support/program.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"

namespace quad_support {

int runProgram(const std::string& name, const std::function<int()>& body, std::string* message) {
  std::setlocale(LC_ALL, "C");
  installInterruptHandlers();
  std::signal(SIGXFSZ,
              SIG_IGN);  // a limit on file sizes is then an error of write(), with its message
  const auto complain = [&](const std::string& text, int code) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), text.c_str());
    if (message) *message = text;
    return code;
  };
  try {
    const int code = body();
    print("", "what it was to show is lost");
    return code;
  } catch (const Interrupted& e) {
    return complain("interrupted; nothing was left half-written", 128 + e.signal());
  } catch (const std::invalid_argument& e) {
    return complain(e.what(), kBadInput);
  } catch (const NegativeAnswer& e) {
    return complain(e.what(), kNegativeAnswer);
  } catch (const SimulationError& e) {
    return complain(e.what(), kSimulationFailed);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", kEnvironment);
  } catch (const std::exception& e) {
    return complain(e.what(), kEnvironment);
  }
}

void print(const std::string& text, const std::string& kept) {
  errno = 0;
  const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (written && std::ferror(stdout) == 0) return;
  throw EnvironmentError(fmt::format("standard output cannot be written ({}); {}",
                                     errno != 0 ? std::strerror(errno) : "full or closed", kept));
}

}  // namespace quad_support
