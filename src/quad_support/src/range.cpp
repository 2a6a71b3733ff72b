#include <fmt/core.h>

#include <cmath>

#include "quad_support/number_format.hpp"
#include "range_text.hpp"

namespace quad_support {

Range Range::any(std::string unit) { return closed(-HUGE_VAL, HUGE_VAL, std::move(unit)); }
Range Range::positive(std::string unit) { return open(0.0, HUGE_VAL, std::move(unit)); }
Range Range::nonNegative(std::string unit) { return closed(0.0, HUGE_VAL, std::move(unit)); }
Range Range::closed(double min, double max, std::string unit) {
  return {min, max, false, false, std::move(unit)};
}
Range Range::open(double min, double max, std::string unit) {
  return {min, max, true, true, std::move(unit)};
}

std::string describe(const Range& r, const std::string& what) {
  const std::string unit = r.unit.empty() ? "" : " " + r.unit;
  if (std::isfinite(r.min) && std::isfinite(r.max)) {
    return fmt::format("must {} {}{}, {}{}{}", what.empty() ? "lie in" : "be " + what + "in",
                       r.open_min ? "(" : "[", shortest(r.min), shortest(r.max),
                       r.open_max ? ")" : "]", unit);
  }
  if (std::isfinite(r.min))
    return fmt::format("must be {}{} {}{}", what, r.open_min ? ">" : ">=", shortest(r.min), unit);
  if (std::isfinite(r.max))
    return fmt::format("must be {}{} {}{}", what, r.open_max ? "<" : "<=", shortest(r.max), unit);
  return "must be a finite number" + (r.unit.empty() ? "" : " in " + r.unit);
}

bool contains(const Range& r, double value) {
  return (r.open_min ? value > r.min : value >= r.min) &&
         (r.open_max ? value < r.max : value <= r.max);
}

}  // namespace quad_support
