#include <cmath>
#include <sstream>

#include "quad_sim/state_archive.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

const char kTitle[] = "quad_sim state 1";  // 1: the format

[[noreturn]] void fail(const std::string& problem) {
  throw quad_support::DataError("saved state: " + problem);
}

std::string lineAfter(std::istream& in, const std::string& key) {
  std::string line;
  if (!std::getline(in, line) || line.rfind(key + " ", 0) != 0) fail("no line '" + key + " …'");
  return line.substr(key.size() + 1);
}

double number(const std::string& text) {
  try {
    const double x = quad_support::parseDouble(text);
    if (std::isfinite(x)) return x;
  } catch (const std::invalid_argument&) {
  }
  fail("'" + text + "' is not a finite number");
}

}  // namespace

std::string toText(const SavedState& state) {
  std::string text = std::string(kTitle) + "\nof " + state.simulator + "\nstep " +
                     std::to_string(state.step_count) + "\nnumbers";
  for (const double x : state.numbers) {
    text += ' ';
    quad_support::appendShortest(text, x);
  }
  return text + "\n";
}

SavedState savedStateFromText(const std::string& text) {
  std::istringstream in(text);
  std::string title;
  if (!std::getline(in, title) || title != kTitle)
    fail(std::string("the first line is not '") + kTitle + "'");
  SavedState state;
  state.simulator = lineAfter(in, "of");
  const double steps = number(lineAfter(in, "step"));
  constexpr double kMost = 9007199254740992.0;  // 2^53
  if (steps < 0 || steps > kMost || steps != std::floor(steps))
    fail("the step count is not a whole number >= 0");
  state.step_count = static_cast<std::int64_t>(steps);
  std::istringstream numbers(lineAfter(in, "numbers"));
  for (std::string word; numbers >> word;) state.numbers.push_back(number(word));
  return state;
}

}  // namespace quad_sim
