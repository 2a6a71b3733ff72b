// Damaged vehicle descriptions: whatever is deleted, doubled or set to an odd number, the answer is
// a clear error or a vehicle that flies.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "hummingbird.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/random_stream.hpp"
#include "rotors_style.hpp"

namespace quad_sim {
namespace {

/// A source of choices that is the same everywhere.
class Choice {
 public:
  explicit Choice(std::uint64_t run) : stream_(20240501, run, 1) {}
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(stream_.uniform(step_++) * static_cast<double>(n));
  }

 private:
  quad_support::RandomStream stream_;
  std::uint64_t step_ = 0;
};

/// Begin and length of every number in the text.
std::vector<std::pair<std::size_t, std::size_t>> numbers(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 1; i < text.size();) {
    const char before = text[i - 1];
    const bool starts = (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '-') &&
                        (before == '"' || before == '>' || before == ' ');
    if (!starts) {
      ++i;
      continue;
    }
    const std::size_t length =
        std::min(text.find_first_not_of("0123456789.eE+-", i), text.size()) - i;
    found.emplace_back(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return found;
}

/// The tags of the text: from each '<' to its '>'.
std::vector<std::pair<std::size_t, std::size_t>> tags(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i + 1)) {
    const std::size_t end = text.find('>', i);
    if (end == std::string::npos) break;
    found.emplace_back(i, end + 1 - i);
  }
  return found;
}

const char* const kOdd[] = {"0",   "-1",           "1e300", "-1e300", "1e-300", "nan",
                            "inf", "-inf",         "",      "x",      "1e999",  "0x10",
                            "1,5", "999999999999", "1 2",   "1e-9",   "2"};

void damage(std::string& text, Choice& choose) {
  switch (choose.below(6)) {
    case 0: {  // a piece of any place
      if (text.empty()) return;
      const std::size_t at = choose.below(text.size());
      text.erase(at, 1 + choose.below(80));
      return;
    }
    case 1: {  // a whole tag
      const auto all = tags(text);
      if (all.empty()) return;
      const auto& tag = all[choose.below(all.size())];
      text.erase(tag.first, tag.second);
      return;
    }
    case 2: {  // an element of one line is doubled
      const std::size_t at = choose.below(text.size()), begin = text.rfind('\n', at),
                        end = text.find('\n', at);
      if (begin == std::string::npos || end == std::string::npos || begin >= end) return;
      text.insert(end, text.substr(begin, end - begin));
      return;
    }
    case 3: {  // a line goes
      const std::size_t at = choose.below(text.size()), begin = text.rfind('\n', at),
                        end = text.find('\n', at);
      if (begin == std::string::npos || end == std::string::npos || begin >= end) return;
      text.erase(begin, end - begin);
      return;
    }
    default: {  // an odd number
      const auto all = numbers(text);
      if (all.empty()) return;
      const auto& number = all[choose.below(all.size())];
      text.replace(number.first, number.second, kOdd[choose.below(std::size(kOdd))]);
    }
  }
}

/// Reads it and, if it reads, lets it fall on the ground and spin its rotors. Returns whether it
/// was a vehicle.
bool fly(const std::string& text, Multibody multibody) {
  try {
    const VehicleModel m = parseVehicle(text, "fuzzed.urdf");
    EXPECT_GT(m.mass, 0);
    EXPECT_TRUE(std::isfinite(m.mass));
    EXPECT_TRUE(m.inertia_B.allFinite());
    EXPECT_GT(m.inertia_B.determinant(), 0);
    EXPECT_FALSE(m.rotors.empty());
    SimulatorOptions options;
    options.multibody = multibody;
    Simulator s(m, options);
    s.setCommand(std::vector<double>(m.rotors.size(), 300.0));
    s.advance(5);
    EXPECT_TRUE(s.state().p_WB.allFinite());
    return true;
  } catch (const std::invalid_argument& e) {  // ConfigError and DataError are such
    EXPECT_STRNE(e.what(), "");
  } catch (const quad_support::SimulationError& e) {  // a rotor of 1e300 N: flown, and said so
    EXPECT_STRNE(e.what(), "");
  }
  return false;
}

TEST(FuzzedUrdf, IsAClearErrorOrAVehicle) {
  // QUAD_FUZZ_RUNS for more: 100 000 take minutes.
  const char* const wanted = std::getenv("QUAD_FUZZ_RUNS");
  const std::uint64_t runs = wanted ? std::strtoull(wanted, nullptr, 10) : 1500;
  const std::vector<std::string> good = {hummingbirdText(), test::urdf(test::firefly()),
                                         test::urdf(test::asymmetric())};
  int vehicles = 0, errors = 0;
  for (std::uint64_t run = 0; run < runs; ++run) {
    SCOPED_TRACE(testing::Message() << "run " << run);
    Choice choose(run);
    std::string text = good[run % good.size()];
    for (std::size_t n = 1 + choose.below(4); n > 0; --n) damage(text, choose);
    (fly(text, run % 2 == 0 ? Multibody::kFolded : Multibody::kHinged) ? vehicles : errors) += 1;
  }
  std::printf("%d fuzzed descriptions: %d vehicles, %d errors\n", vehicles + errors, vehicles,
              errors);
  EXPECT_GT(vehicles, static_cast<int>(runs / 20));  // or the damage is too coarse to find anything
  EXPECT_GT(errors, static_cast<int>(runs / 20));
}

}  // namespace
}  // namespace quad_sim
