/// The Hummingbird of the build, for the tests of this package.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "quad_sim/simulation_config.hpp"
#include "quad_support/atomic_file.hpp"

namespace quad_sim {

inline std::string hummingbirdPath() { return findUrdf("hummingbird.urdf", ""); }
inline std::string hummingbirdText() { return quad_support::readFile(hummingbirdPath()); }
inline VehicleModel hummingbird() { return loadVehicle(hummingbirdPath()); }

/// `text` with the first `from` replaced; fails the test if it is not there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "nothing to replace: " << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// What the exception of `action` says; fails the test if it is not of that type.
template <class Exception, class Action>
std::string complaint(const Action& action) {
  try {
    action();
  } catch (const Exception& e) {
    return e.what();
  }
  ADD_FAILURE() << "no exception";
  return "";
}

}  // namespace quad_sim
