/// Checks of arguments shared by the sources; each says what is wrong, with value and limit.
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "quad_support/errors.hpp"

namespace explore_opt {

template <typename... Args>
void require(bool condition, fmt::format_string<Args...> text, Args&&... args) {
  if (!condition) throw quad_support::DataError(fmt::format(text, std::forward<Args>(args)...));
}

/// What work() returns; its complaints get the name of the file they are about.
template <typename Work>
auto withName(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const quad_support::NegativeAnswer& e) {
    throw quad_support::NegativeAnswer(name + ": " + e.what());
  } catch (const quad_support::DataError& e) {
    throw quad_support::DataError(name + ": " + e.what());
  }
}

inline void requirePositive(double value, const char* name) {
  require(std::isfinite(value) && value > 0.0, "{} = {}; must be a finite number above 0", name,
          value);
}

inline void requireShape(const Eigen::MatrixXd& m, Eigen::Index rows, Eigen::Index cols,
                         const char* name) {
  require(m.rows() == rows && m.cols() == cols, "{} is {} x {}; must be {} x {}", name, m.rows(),
          m.cols(), rows, cols);
}

inline void requireFinite(const Eigen::MatrixXd& m, const char* name) {
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      require(std::isfinite(m(i, j)), "{}: row {}, column {} is {}; must be finite", name, i + 1,
              j + 1, m(i, j));
    }
  }
}

/// States x_0 ... x_T beside inputs u_0 ... u_{T-1}.
inline void requireTrajectory(const Eigen::MatrixXd& X, const Eigen::MatrixXd& U) {
  require(X.rows() >= 1 && U.rows() >= 1,
          "a trajectory needs at least one state and one input; X is {} x {}, U {} x {}", X.rows(),
          X.cols(), U.rows(), U.cols());
  require(X.cols() == U.cols() + 1,
          "X has {} columns and U {}; X must have one more (x_0 ... x_T, u_0 ... u_T-1)", X.cols(),
          U.cols());
  requireFinite(X, "X");
  requireFinite(U, "U");
}

}  // namespace explore_opt
