/// Numbers that need a name and no unit.
#pragma once

namespace quad_support {

constexpr double kPi = 3.14159265358979323846;

}  // namespace quad_support
