#pragma once

#include <string>
#include <string_view>

namespace quad_support {

/// SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace quad_support
