#include "quad_control/time_manager.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace quad_control {

ForgettingMean::ForgettingMean(double forgetting_factor) : forgetting_factor_(forgetting_factor) {
  if (!(forgetting_factor > 0.0 && forgetting_factor < 1.0)) {
    throw std::invalid_argument(
        fmt::format("forgetting factor = {}; must lie in (0, 1)", forgetting_factor));
  }
}

void ForgettingMean::add(double value) {
  weight_ = forgetting_factor_ * weight_ + 1.0;
  mean_ += (value - mean_) / weight_;
}

void ForgettingMean::reset() { weight_ = mean_ = 0.0; }

double TimeManager::waitFor(double desired) const { return std::max(0.0, desired - noise_.mean()); }

void IntervalStatistics::add(double interval, double desired) {
  ++count_;
  const double from_old_mean = interval - mean_;
  mean_ += from_old_mean / static_cast<double>(count_);
  squares_ += from_old_mean * (interval - mean_);
  max_error_ = std::max(max_error_, std::abs(interval - desired));
}

double IntervalStatistics::std() const {
  return count_ < 2 ? 0.0 : std::sqrt(squares_ / static_cast<double>(count_ - 1));
}

}  // namespace quad_control
