#include "design_tools.hpp"

#include <cmath>

#include "quad_support/linear_algebra.hpp"
#include "quad_support/random_stream.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLeastEigenvalueRatio = 1e-9;
constexpr std::uint64_t kDirectionStream = 0x646972656374;  // of this purpose alone
constexpr std::uint64_t kSimpleDirections = 1 << 20;        // apart from the solver's random starts

/// λ_max(H(Z)), from above: what rounding may have hidden in the sums of products is added.
double largestEigenvalue(const PredictedResponse& response, const MatrixXd& Z) {
  PredictedResponse sizes;
  for (const MatrixXd& F : response.factors) sizes.factors.push_back(F.cwiseAbs());
  const double rounding =
      8.0 * std::numeric_limits<double>::epsilon() * sizes.gramOf(Z.cwiseAbs()).norm();
  return quad_support::SymmetricEigen(response.gramOf(Z)).values.tail(1)(0) +
         rounding;
}

}  // namespace

bool DesignTask::excites(const VectorXd& direction) const {
  MatrixXd F = response.factor(direction);
  if (F.rows() < F.cols()) return false;
  const VectorXd lengths = F.colwise().norm();
  if (!(lengths.minCoeff() > 0.0) || !lengths.allFinite()) return false;
  F = F * lengths.cwiseInverse().asDiagonal();
  const VectorXd sigma = quad_support::singularValues(F);
  const double ratio = sigma(sigma.size() - 1) / sigma(0);
  return ratio * ratio > kLeastEigenvalueRatio;
}

double DesignTask::cost(const VectorXd& direction) const {
  if (!excites(direction)) return std::numeric_limits<double>::infinity();
  return std::sqrt(gamma_w / response.lambdaMin(direction)) * direction.norm();
}

VectorXd DesignTask::onBoundary(const VectorXd& direction) const {
  constexpr double kUp = 1.0 + 4e-16;
  VectorXd a = direction * std::sqrt(gamma_w / response.lambdaMin(direction));
  for (int i = 0; i < 50 && response.lambdaMin(a) < gamma_w; ++i) a *= kUp + i * 1e-15;
  return a;
}

Certificate DesignTask::certify(const MatrixXd& Z) const {
  const quad_support::SymmetricEigen cone(Z);
  const VectorXd positive = cone.values.cwiseMax(0.0);
  Certificate certificate;
  certificate.Z = cone.vectors * positive.asDiagonal() * cone.vectors.transpose();
  certificate.Z = 0.5 * (certificate.Z + certificate.Z.transpose()).eval();
  const double largest = largestEigenvalue(response, certificate.Z);
  const double square = gamma_w * certificate.Z.trace() / largest;
  if (!(largest > 0.0) || !std::isfinite(square)) return {MatrixXd::Zero(Z.rows(), Z.cols()), 0.0};
  certificate.Z /= 2.0 * largest;  // the multiplier of ½‖a‖²: 2 λ_max(H(Z)) = 1
  certificate.bound = std::sqrt(square) * (1.0 - 1e-13);
  return certificate;
}

MatrixXd DesignTask::table(const VectorXd& a) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(a.data(), a.size() / num_inputs, num_inputs);
}

VectorXd DesignTask::components(const MatrixXd& table) const {
  const MatrixXd transposed = table.transpose();
  return Eigen::Map<const VectorXd>(transposed.data(), transposed.size());
}

VectorXd randomDirection(const DesignTask& task, std::uint64_t seed, std::uint64_t index) {
  const quad_support::RandomStream random(seed, 0, kDirectionStream);
  VectorXd direction(task.response.numAmplitudes());
  for (int i = 0; i < direction.size(); ++i)
    direction(i) = random.normal(index, static_cast<std::uint64_t>(i));
  return direction;
}

std::optional<VectorXd> cheapestSimpleDirection(const DesignTask& task, std::uint64_t seed) {
  const int p = task.response.numAmplitudes();
  std::vector<VectorXd> directions = {VectorXd::Ones(p)};
  for (int i = 0; i < p; ++i) directions.push_back(VectorXd::Unit(p, i));
  for (std::uint64_t i = 0; i < 8; ++i) {
    const VectorXd normal = randomDirection(task, seed, kSimpleDirections + i);
    directions.push_back(normal);
    directions.push_back(normal.cwiseSign());
  }
  std::optional<VectorXd> best;
  double least = std::numeric_limits<double>::infinity();
  for (const VectorXd& direction : directions) {
    const double cost = task.cost(direction);
    if (cost >= least) continue;
    least = cost;
    best = direction;
  }
  if (best) best = task.onBoundary(*best);
  return best;
}

}  // namespace explore_opt
