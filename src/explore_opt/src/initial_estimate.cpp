#include "explore_opt/initial_estimate.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "checks.hpp"
#include "explore_opt/altitude_model.hpp"
#include "quad_support/random_stream.hpp"

namespace explore_opt {
namespace {

constexpr std::uint64_t kEstimateStream = 0x7461626c65323131;  // of this purpose alone
constexpr int kMaxRejected = 1000;

Eigen::MatrixXd theta(const AltitudeParameters& p) {
  const LinearSystem model = altitudeModel(p.mass, p.sampling_period, 0.0);
  Eigen::MatrixXd joined(2, 3);
  joined << model.A, model.B;
  return joined;
}

/// λ_D ‖vec(Θ_true - Θ̂(σ))‖² - 1 along one pair of normals.
class Excess {
 public:
  Excess(const AltitudeParameters& truth, double closeness, double n1, double n2)
      : truth_(truth), closeness_(closeness), n1_(n1), n2_(n2) {}

  AltitudeParameters at(double sigma) const {
    return {truth_.sampling_period + sigma * n1_, truth_.mass + sigma * n2_};
  }
  bool physical(double sigma) const {
    return at(sigma).sampling_period > 0.0 && at(sigma).mass > 0.0;
  }
  double operator()(double sigma) const {
    return closeness_ * parameterError(truth_, at(sigma)).squaredNorm() - 1.0;
  }

 private:
  AltitudeParameters truth_;
  double closeness_, n1_, n2_;
};

double bisect(const Excess& excess, double below, double above) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (below + above);
    if (middle <= below || middle >= above) break;
    (excess(middle) < 0.0 ? below : above) = middle;
  }
  return above;
}

/// The smallest σ > 0 with excess zero before a parameter reaches zero; the scan multiplies σ
/// by 1.02.
std::optional<double> smallestRoot(const Excess& excess, double scale) {
  double below = 0.0;
  for (double sigma = 1e-9 * scale; sigma < 1e9 * scale; sigma *= 1.02) {
    if (!excess.physical(sigma)) return std::nullopt;
    if (excess(sigma) >= 0.0) return bisect(excess, below, sigma);
    below = sigma;
  }
  return std::nullopt;
}

}  // namespace

Eigen::VectorXd parameterError(const AltitudeParameters& truth,
                               const AltitudeParameters& estimate) {
  const Eigen::MatrixXd difference = theta(truth) - theta(estimate);
  return Eigen::Map<const Eigen::VectorXd>(difference.data(), difference.size());
}

double errorNorm(const Eigen::MatrixXd& theta_true, const Eigen::MatrixXd& theta_estimate) {
  requireShape(theta_true, 2, 3, "true Theta");
  requireShape(theta_estimate, 2, 3, "estimated Theta");
  const Eigen::MatrixXd e = theta_true - theta_estimate;
  return Eigen::Vector3d(e(0, 1), e(0, 2), e(1, 2)).norm();
}

double closenessOfEstimate(const AltitudeParameters& truth, const AltitudeParameters& estimate) {
  return 1.0 / parameterError(truth, estimate).squaredNorm();
}

InitialEstimate drawInitialEstimate(const AltitudeParameters& truth, double closeness,
                                    std::uint64_t seed, std::uint64_t run) {
  requirePositive(truth.sampling_period, "true sampling period [s]");
  requirePositive(truth.mass, "true mass [kg]");
  requirePositive(closeness, "closeness λ_D");
  const quad_support::RandomStream random(seed, run, kEstimateStream);
  InitialEstimate estimate;
  for (; estimate.rejected < kMaxRejected; ++estimate.rejected) {
    const auto pair = static_cast<std::uint64_t>(estimate.rejected);
    const Excess excess(truth, closeness, random.normal(pair, 0), random.normal(pair, 1));
    const auto sigma = smallestRoot(excess, std::min(truth.sampling_period, truth.mass));
    if (!sigma) continue;
    estimate.standard_deviation = *sigma;
    estimate.parameters = excess.at(*sigma);
    return estimate;
  }
  throw quad_support::DataError(fmt::format(
      "λ_D = {}: no physical estimate (dT > 0, m > 0) in {} draws; ask for a larger λ_D", closeness,
      kMaxRejected));
}

}  // namespace explore_opt
