#include "explore_opt/altitude_model.hpp"

#include <cmath>

#include "checks.hpp"
#include "constants.hpp"

namespace explore_opt {
namespace {

void requireGravity(double gravity) {
  require(std::isfinite(gravity) && gravity >= 0.0,
          "gravity = {} m/s²; must be a finite number, 0 or above", gravity);
}

}  // namespace

LinearSystem altitudeModel(double mass, double sampling_period, double gravity) {
  requirePositive(mass, "mass [kg]");
  requirePositive(sampling_period, "sampling period [s]");
  requireGravity(gravity);
  const double dT = sampling_period;  // Eq. (2.2)
  LinearSystem model;
  model.A = (Eigen::Matrix2d() << 1.0, dT, 0.0, 1.0).finished();
  model.B = Eigen::Vector2d(dT * dT / (2.0 * mass), dT / mass);
  model.W = Eigen::Vector2d(-gravity * dT * dT / 2.0, -gravity * dT);
  return model;
}

double crossoverFrequency(double mass) {
  requirePositive(mass, "mass [kg]");
  return 1.0 / (2.0 * kPi * mass);  // |1/(j 2π f m)| = 1
}

FrequencyGrid crossoverGrid(double mass, double sampling_period, double time_unit) {
  requirePositive(sampling_period, "sampling period [s]");
  requirePositive(time_unit, "time unit [s]");
  FrequencyGrid grid;
  grid.crossover = crossoverFrequency(mass);
  grid.exact_time = 8.0 / grid.crossover;
  grid.exploration_time = time_unit * std::round(grid.exact_time / time_unit);
  const double samples = std::round(grid.exploration_time / sampling_period);
  grid.harmonics = {3, 6, 8, 10};
  require(
      samples > 2 * grid.harmonics.back() && samples < 1e9,
      "T = {} s / {} s = {} samples; the lines 3, 6, 8, 10 need more than 20 and fewer than 1e9",
      grid.exploration_time, sampling_period, samples);
  grid.num_samples = static_cast<int>(samples);
  for (const int h : grid.harmonics)
    grid.frequencies.push_back(h / (grid.num_samples * sampling_period));
  return grid;
}

}  // namespace explore_opt
