#include "sampled_loop.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>
#include <utility>

#include "quad_support/constants.hpp"

namespace quad_control {
namespace {

using Eigen::MatrixXd;

using quad_support::kPi;

// x(t) for an input held over `time`: exp([A B; 0 0] t) = [Ad Bd; 0 I], as in thesis section 2.3.
std::pair<MatrixXd, MatrixXd> hold(const LinearPlant& plant, double time) {
  const Eigen::Index n = plant.A.rows(), m = plant.B.cols();
  MatrixXd big = MatrixXd::Zero(n + m, n + m);
  big.topLeftCorner(n, n) = plant.A * time;
  big.topRightCorner(n, m) = plant.B * time;
  const MatrixXd exponential = big.exp();
  return {exponential.topLeftCorner(n, n), exponential.topRightCorner(n, m)};
}

void check(const LinearPlant& plant) {
  const Eigen::Index n = plant.A.rows();
  const auto loops = static_cast<Eigen::Index>(plant.position.size());
  bool fits = n > 0 && plant.A.cols() == n && plant.B.rows() == n && plant.B.cols() == loops &&
              plant.velocity.size() == plant.position.size();
  for (const auto* rows : {&plant.position, &plant.velocity}) {
    for (const int row : *rows) fits = fits && row >= 0 && row < n;
  }
  if (!fits)
    throw std::invalid_argument(
        "sampled loop: the shapes of A, B and the measured rows do not fit together");
}

// Position and velocity rows of loop i: u_i = −(proportional · x) − w_i, w_i += integral · x.
struct LoopRows {
  Eigen::RowVectorXd proportional, integral;
};

LoopRows loopRows(const LinearPlant& plant, const PiGains& gains, double period, std::size_t loop) {
  LoopRows rows{Eigen::RowVectorXd::Zero(plant.A.rows()), Eigen::RowVectorXd::Zero(plant.A.rows())};
  rows.proportional(plant.position[loop]) = gains.position;
  rows.proportional(plant.velocity[loop]) = gains.velocity;
  rows.integral(plant.position[loop]) = gains.position_integral * period;
  rows.integral(plant.velocity[loop]) = gains.velocity_integral * period;
  return rows;
}

bool integrates(const PiGains& gains) {
  return gains.position_integral > 0.0 || gains.velocity_integral > 0.0;
}

PiGains scaled(const PiGains& gains, double factor) {
  return {gains.position * factor, gains.position_integral * factor, gains.velocity * factor,
          gains.velocity_integral * factor};
}

// The loop's gain L(z) seen at input `loop`, the other loops closed.
class OpenLoop {
 public:
  OpenLoop(const LinearPlant& plant, const SampledPlant& sampled, const std::vector<PiGains>& gains,
           int loop)
      : plant_(plant), sampled_(sampled), gains_(gains), loop_(loop) {}

  std::complex<double> operator()(double frequency) const {
    const std::complex<double> z = std::polar(1.0, frequency * sampled_.period);
    const Eigen::Index n = plant_.A.rows();
    const auto loops = static_cast<Eigen::Index>(gains_.size());
    // P(z) from u to x, then C(z) from x to −u: L_i = [C P (I + C' P)⁻¹]_ii with C' lacking row i.
    const Eigen::MatrixXcd P =
        (z * MatrixXd::Identity(n, n) - sampled_.A.cast<std::complex<double>>())
            .partialPivLu()
            .solve(sampled_.B_old.cast<std::complex<double>>() / z + sampled_.B_new) *
        std::pow(z, -sampled_.whole_periods);
    Eigen::MatrixXcd C(loops, n);
    for (Eigen::Index i = 0; i < loops; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const LoopRows rows = loopRows(plant_, gains_[index], sampled_.period, index);
      C.row(i) = rows.proportional + rows.integral * (z / (z - 1.0));
    }
    Eigen::MatrixXcd others = C;
    others.row(loop_).setZero();
    const Eigen::MatrixXcd closed = Eigen::MatrixXcd::Identity(loops, loops) + others * P;
    return (C.row(loop_) * P * closed.inverse())(loop_);
  }

 private:
  const LinearPlant& plant_;
  const SampledPlant& sampled_;
  const std::vector<PiGains>& gains_;
  int loop_;
};

// The edge between `inside` (stable) and `outside` (not), by bisection to 2^-40 of their distance.
template <class Stable>
double edge(double inside, double outside, const Stable& stable) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    (stable(middle) ? inside : outside) = middle;
  }
  return inside;
}

// Largest (or smallest) factor on the loop's gains, between 1 and `limit`, that keeps it stable.
// Walks out 2 % at a time to the first loss of stability, so that an unstable gap is not stepped
// over.
double gainMargin(const LinearPlant& plant, const SampledPlant& sampled, std::vector<PiGains> gains,
                  int loop, double limit) {
  const auto index = static_cast<std::size_t>(loop);
  const PiGains nominal = gains[index];
  const auto stable = [&](double factor) {
    gains[index] = scaled(nominal, factor);
    return spectralRadius(closedLoop(plant, sampled, gains)) < 1.0;
  };
  const double ratio = limit > 1.0 ? 1.02 : 1.0 / 1.02;
  for (double factor = 1.0;; factor *= ratio) {
    if (limit > 1.0 ? factor >= limit : factor <= limit) return limit;
    if (!stable(factor * ratio)) return edge(factor, factor * ratio, stable);
  }
}

double delayMargin(const LinearPlant& plant, const SampledPlant& sampled,
                   const std::vector<PiGains>& gains) {
  const auto stable = [&](double delay) {
    return spectralRadius(closedLoop(
               plant, discretise(plant, sampled.period, sampled.latency + delay), gains)) < 1.0;
  };
  const double limit = 4.0 * sampled.period, stride = 0.05 * sampled.period;
  for (double delay = 0.0; delay < limit; delay += stride) {
    if (!stable(delay + stride)) return edge(delay, delay + stride, stable);
  }
  return limit;
}

}  // namespace

SampledPlant discretise(const LinearPlant& plant, double period, double latency) {
  check(plant);
  if (!(period > 0.0 && latency >= 0.0 && std::isfinite(period) && std::isfinite(latency))) {
    throw std::invalid_argument(fmt::format(
        "sampled loop: period = {} s, latency = {} s; must be > 0 s and >= 0 s", period, latency));
  }
  const double whole = std::floor(latency / period);
  const double rest = std::clamp(latency - whole * period, 0.0, period);
  const auto [A_old, B_old] = hold(plant, rest);
  const auto [A_new, B_new] = hold(plant, period - rest);
  return {A_new * A_old, A_new * B_old, B_new, period, latency, static_cast<int>(whole)};
}

Eigen::MatrixXd closedLoop(const LinearPlant& plant, const SampledPlant& sampled,
                           const std::vector<PiGains>& gains) {
  check(plant);
  const auto loops = static_cast<Eigen::Index>(gains.size());
  if (loops != plant.B.cols())
    throw std::invalid_argument("sampled loop: one set of gains a loop is needed");
  const Eigen::Index n = plant.A.rows();
  const Eigen::Index sums = std::count_if(gains.begin(), gains.end(), integrates);
  const Eigen::Index size = n + sums + loops * (sampled.whole_periods + 1);
  MatrixXd command = MatrixXd::Zero(loops, size);  // u[k] as a function of the state
  MatrixXd closed = MatrixXd::Zero(size, size);
  Eigen::Index sum = n;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const LoopRows rows = loopRows(plant, gains[i], sampled.period, i);
    const auto row = static_cast<Eigen::Index>(i);
    command.row(row).head(n) = -rows.proportional - rows.integral;
    if (!integrates(gains[i])) continue;
    command(row, sum) = -1.0;
    closed.row(sum).head(n) = rows.integral;
    closed(sum, sum) = 1.0;
    ++sum;
  }
  closed.topLeftCorner(n, n) = sampled.A;
  closed.topRightCorner(n, loops) = sampled.B_old;
  if (sampled.whole_periods == 0) {
    closed.topRows(n) += sampled.B_new * command;
  } else {
    closed.block(0, size - 2 * loops, n, loops) += sampled.B_new;
  }
  closed.middleRows(n + sums, loops) =
      command;  // the newest of the inputs kept; the others move one place on
  for (Eigen::Index row = n + sums + loops; row < size; ++row) closed(row, row - loops) = 1.0;
  return closed;
}

LoopMargins margins(const LinearPlant& plant, const SampledPlant& sampled,
                    const std::vector<PiGains>& gains, int loop) {
  const double radius = spectralRadius(closedLoop(plant, sampled, gains));
  if (!(radius < 1.0)) {
    throw std::invalid_argument(
        fmt::format("sampled loop: spectral radius {}: not stable, so no margins", radius));
  }
  LoopMargins result;
  result.gain_up = gainMargin(plant, sampled, gains, loop, 50.0);
  result.gain_down = gainMargin(plant, sampled, gains, loop, 0.02);
  result.phase_degrees = 180.0;
  result.delay_s = delayMargin(plant, sampled, gains);
  const OpenLoop open(plant, sampled, gains, loop);
  // 4000 points a four decades: neighbours differ by 0.2 %, and the curves bend over tens of per
  // cent.
  constexpr int kPoints = 4000;
  const double highest = kPi / sampled.period;
  std::complex<double> before = open(highest * 1e-4);
  for (int i = 1; i <= kPoints; ++i) {
    const double frequency =
        highest * std::pow(10.0, 4.0 * (static_cast<double>(i) / kPoints - 1.0));
    const std::complex<double> value = open(frequency);
    result.sensitivity_peak = std::max(result.sensitivity_peak, 1.0 / std::abs(1.0 + value));
    if ((std::abs(before) - 1.0) * (std::abs(value) - 1.0) <= 0.0) {
      result.phase_degrees =
          std::min(result.phase_degrees, std::abs(std::arg(-value)) * 180.0 / kPi);  // to −1
    }
    before = value;
  }
  return result;
}

LinearPlant tiltPlant(const LoopVehicle& vehicle, double climb_rate, double rotor_speed, double lag,
                      bool rolling_moments_add) {
  const double drag = vehicle.num_rotors * rotor_speed * vehicle.drag_coefficient;
  const double rolling = vehicle.num_rotors * rotor_speed * vehicle.rolling_moment_coefficient;
  const double thrust = vehicle.num_rotors * vehicle.thrust_coefficient * rotor_speed * rotor_speed;
  const double h = vehicle.rotor_height;
  const Eigen::RowVector4d slip(1.0, -climb_rate, h, 0.0);  // s = v − ż·angle + h·rate
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A.row(0) = -drag / vehicle.mass * slip;
  A(0, 1) += thrust / vehicle.mass;
  A(1, 2) = 1.0;
  A.row(2) = -h * drag / vehicle.inertia_xx * slip;
  A(2, 3) += 1.0 / vehicle.inertia_xx;
  A(3, 3) = -1.0 / lag;
  const Eigen::Vector4d B(0.0, 0.0, 0.0, 1.0 / lag);
  if (!rolling_moments_add) return {A, B, {1}, {2}};
  // Pitch: v along x_B. Roll: the same equations with v along −y_B, so that tilt still accelerates
  // along +v. The moment −c (s_x, s_y): about x_B it is −c s_pitch, and about y_B −c s_y = +c
  // s_roll.
  LinearPlant both{MatrixXd::Zero(8, 8), MatrixXd::Zero(8, 2), {1, 5}, {2, 6}};
  both.A.topLeftCorner(4, 4) = both.A.bottomRightCorner(4, 4) = A;
  both.A.block(2, 4, 1, 4) = rolling / vehicle.inertia_xx * slip;
  both.A.block(6, 0, 1, 4) = -rolling / vehicle.inertia_xx * slip;
  both.B.topLeftCorner(4, 1) = both.B.bottomRightCorner(4, 1) = B;
  return both;
}

LinearPlant doubleIntegratorPlant(double inertia, double lag) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  A(0, 1) = 1.0;
  A(1, 2) = 1.0 / inertia;
  A(2, 2) = -1.0 / lag;
  return {A, Eigen::Vector3d(0.0, 0.0, 1.0 / lag), {0}, {1}};
}

}  // namespace quad_control
