/// What the benchmarks of the plant fly and how they take the time.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <limits>
#include <vector>

#include "quad_sim/simulation_config.hpp"

namespace quad_sim::bench {

constexpr int kStepsPerInterval = 100;
constexpr double kStep = 0.001, kAltitude = 5000.0, kGravity = 9.8;

inline VehicleModel hummingbird() { return loadVehicle(findUrdf("hummingbird.urdf", "")); }

/// Our simulator with a command and a measurement each 100 steps, from hover.
class Flight {
 public:
  /// @param imbalance  [rad/s] by which one rotor's command differs: 0 hovers, more tumbles
  Flight(Multibody multibody, int intervals, double imbalance = 0)
      : simulator_(hummingbird(), options(multibody)), intervals_(intervals) {
    simulator_.setStartState(equilibrium(simulator_.model(), kGravity, kAltitude));
    command_ = simulator_.command();
    command_[0] += imbalance;
    measurement_ = simulator_.measure();
  }
  double fly() {  ///< returns the altitude [m]
    simulator_.reset();
    for (int i = 0; i < intervals_; ++i) {
      simulator_.setCommand(command_);
      simulator_.advance(kStepsPerInterval);
      simulator_.measure(measurement_);
    }
    return measurement_.odometry.p_WB.z();
  }

 private:
  static SimulatorOptions options(Multibody multibody) {
    SimulatorOptions o;
    o.step = kStep;
    o.gravity = kGravity;
    o.multibody = multibody;
    return o;
  }
  Simulator simulator_;
  int intervals_;
  std::vector<double> command_;
  Measurement measurement_;
};

/// Least seconds of each of several, taken in turns: other work on the machine only adds time, and
/// a slow spell meets all.
template <std::size_t N>
std::array<double, N> bestInTurns(const std::array<std::function<void()>, N>& runs,
                                  int repetitions) {
  std::array<double, N> best;
  best.fill(std::numeric_limits<double>::infinity());
  for (int i = 0; i < repetitions; ++i) {
    for (std::size_t k = 0; k < N; ++k) {
      const auto start = std::chrono::steady_clock::now();
      runs[k]();
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      best[k] = std::min(best[k], took.count());
    }
  }
  return best;
}

}  // namespace quad_sim::bench
