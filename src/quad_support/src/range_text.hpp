/// A range in the words of a complaint.
#pragma once

#include <string>

#include "quad_support/config_reader.hpp"

namespace quad_support {

/// "must be > 0 kg", "must lie in [0, 1]"
/// @param what  "" or "a finite number ", for a value that is none
std::string describe(const Range& r, const std::string& what = "");

bool contains(const Range& r, double value);

}  // namespace quad_support
