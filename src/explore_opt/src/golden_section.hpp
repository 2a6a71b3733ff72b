/// The largest value of a function of one variable that rises, then falls.
#pragma once

namespace explore_opt {

/// The best argument tried, after `steps` steps each of which leaves 0.618 of [low, high]. Minus
/// infinity is the value above the function's domain.
template <typename Function>
double goldenSection(const Function& f, double low, double high, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < steps; ++i) {
    if (at_left >= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = f(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = f(right);
    }
  }
  return at_left >= at_right ? left : right;
}

}  // namespace explore_opt
