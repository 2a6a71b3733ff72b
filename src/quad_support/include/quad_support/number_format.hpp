/// Printing and reading doubles exactly, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace quad_support {

/// Shortest decimal text that reads back as the same double ("0.1", "-2.605e-05", "nan", "inf").
std::string shortest(double value);

/// Appends shortest(value) to `text` without a temporary.
void appendShortest(std::string& text, double value);

/// The whole of `text` as a finite or infinite double.
/// @throws std::invalid_argument if it is not a number or something follows it
double parseDouble(std::string_view text);

}  // namespace quad_support
