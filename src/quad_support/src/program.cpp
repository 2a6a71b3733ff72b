#include "quad_support/program.hpp"

#include <clocale>
#include <cstdio>
#include <exception>
#include <new>

#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"

namespace quad_support {
namespace {

int complain(const std::string& name, const std::string& text, int code) {
  std::fprintf(stderr, "%s: %s\n", name.c_str(), text.c_str());
  return code;
}

}  // namespace

int runProgram(const std::string& name, const std::function<int()>& body) {
  std::setlocale(LC_ALL, "C");
  installInterruptHandlers();
  try {
    return body();
  } catch (const Interrupted& e) {
    return complain(name, "interrupted; nothing was left half-written", 128 + e.signal());
  } catch (const std::invalid_argument& e) {
    return complain(name, e.what(), kBadInput);
  } catch (const SimulationError& e) {
    return complain(name, e.what(), kSimulationFailed);
  } catch (const std::bad_alloc&) {
    return complain(name, "out of memory", kEnvironment);
  } catch (const std::exception& e) {
    return complain(name, e.what(), kEnvironment);
  }
}

}  // namespace quad_support
