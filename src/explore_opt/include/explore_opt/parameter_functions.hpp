/// Functions of the identified parameters, and the interval in which the data leave them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "explore_opt/set_membership.hpp"

namespace explore_opt {

/// constant + Σ weights_ij Θ_ij.
struct AffineFunction {
  double constant = 0.0;
  Eigen::MatrixXd weights;  ///< of the shape of Θ

  double at(const Eigen::MatrixXd& Theta) const;
};

/// An affine function, or the quotient of two: m = dT/B2, say.
struct ParameterFunction {
  std::string name;
  AffineFunction numerator;
  std::optional<AffineFunction> denominator;
};

/// Reads "A12", "2*A12 - B1 + 0.5", "m = 0.1/B2", "1 + A(2,11)/B(1,1)" by the usual precedence:
/// entries (indices from 1, as in the thesis; B2 with one input means B21), numbers, + - * / and
/// parentheses, as long as it comes to a sum of entries or one such sum over another.
/// @throws quad_support::DataError naming the text and what is wrong in it
ParameterFunction parseFunction(const std::string& text, int num_states, int num_inputs);

/// The values a function takes on a set. Ends are infinite where a denominator can vanish.
struct Interval {
  double value = 0.0;  ///< at the centre
  double lower = 0.0, upper = 0.0;
};

/// c^Tθ̂ ± sqrt(G c^T P c) for an affine function; for a quotient the roots of the quadratic whose
/// sign says whether the hyperplane numerator = ρ denominator meets the ellipsoid (math: Fieller).
/// Exact, not linearised. Empty set: none.
std::optional<Interval> intervalOf(const FeasibleSet& set, const ParameterFunction& function);

}  // namespace explore_opt
