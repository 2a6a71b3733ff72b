/// Time management of thesis section 1.2.4: how long to let the simulator run so that an interval
/// has the length asked.
#pragma once

#include <cstdint>

namespace quad_control {

/// Mean with a forgetting factor, x̂_k = (1/W) Σ_{i=1..k} λ^{k−i} x_i, W = Σ_{i=1..k} λ^{k−i}
/// (thesis section 1.2.4), by the recursion W_k = λ W_{k−1} + 1, x̂_k = x̂_{k−1} + (x_k − x̂_{k−1}) /
/// W_k.
class ForgettingMean {
 public:
  /// @throws std::invalid_argument unless 0 < λ < 1
  explicit ForgettingMean(double forgetting_factor);

  void add(double value);
  double mean() const { return mean_; }  ///< x̂_k; 0 before the first value
  void reset();

 private:
  double forgetting_factor_;
  double weight_ = 0.0, mean_ = 0.0;
};

/// The controller of thesis Fig. 1.5: u_k = max(0, dT_des − x̂_{k−1}), where x̂ is the
/// forgetting-factor mean of x^noise = dT_sim − u, the time the simulator runs on because a service
/// call takes time. All times in seconds.
class TimeManager {
 public:
  /// @throws std::invalid_argument unless 0 < λ < 1
  explicit TimeManager(double forgetting_factor) : noise_(forgetting_factor) {}

  /// dT_ctrl [s]: how long to wait between unpause and pause for an interval of `desired` [s].
  double waitFor(double desired) const;
  /// Tells how long the interval came out in simulated time after waiting `wait`; both [s].
  void measured(double wait, double interval) { noise_.add(interval - wait); }
  double estimatedDelay() const { return noise_.mean(); }  ///< x̂ [s]; 0 before the first interval
  void reset() { noise_.reset(); }

 private:
  ForgettingMean noise_;
};

/// Mean, standard deviation and largest error of the intervals of a flight, by Welford's updates.
class IntervalStatistics {
 public:
  /// @param interval  measured length [s]  @param desired  length asked for [s]
  void add(double interval, double desired);

  std::int64_t count() const { return count_; }
  double mean() const { return mean_; }  ///< [s]; 0 without intervals
  double std() const;                    ///< of the sample (n − 1) [s]; 0 below two intervals
  double maxAbsError() const { return max_error_; }  ///< max |interval − desired| [s]

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0, squares_ = 0.0, max_error_ = 0.0;
};

}  // namespace quad_control
