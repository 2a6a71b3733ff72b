#include "design_tools.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "constants.hpp"
#include "golden_section.hpp"
#include "quad_support/linear_algebra.hpp"
#include "quad_support/random_stream.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLeastEigenvalueRatio = 1e-14;
constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr std::uint64_t kDirectionStream = 0x646972656374;  // of this purpose alone
constexpr std::uint64_t kSimpleDirections = 1 << 20;        // apart from the solver's random starts

/// F_a Y, a column each: products of columns are H(Y Yᵀ)_ab.
MatrixXd weighted(const std::vector<MatrixXd>& factors, const MatrixXd& root) {
  MatrixXd all(factors.front().rows() * root.cols(), static_cast<Index>(factors.size()));
  for (std::size_t a = 0; a < factors.size(); ++a)
    all.col(static_cast<Index>(a)) = (factors[a] * root).reshaped();
  return all;
}

/// λ_max(H(Y Yᵀ)), from above: what rounding may have hidden in the sums of products is added.
double largestEigenvalue(const PredictedResponse& response, const MatrixXd& root) {
  const MatrixXd all = weighted(response.factors, root), sizes = all.cwiseAbs();
  std::vector<MatrixXd> absolute;
  for (const MatrixXd& F : response.factors) absolute.push_back(F.cwiseAbs());
  const MatrixXd error = 2.0 * weighted(absolute, root.cwiseAbs()) + sizes;
  const double rounding = 8.0 * kEps * (sizes.transpose() * error).norm();
  return quad_support::symmetricEigenvalues(all.transpose() * all).tail(1)(0) + rounding;
}

/// The Lagrangian ½‖b‖² + t(½ bᵀG b + gᵀb + c) of a multiplier scaled by t.
struct ScaledLagrangian {
  MatrixXd G;
  VectorXd g;
  double c = 0.0, size = 0.0;  // size: of the terms of c, for their rounding

  /// Its least value over b, -infinity if it has none.
  double leastValue(double t) const {
    MatrixXd P = t * G;
    P.diagonal().array() += 1.0 - 1e-13;
    const Eigen::LLT<MatrixXd> llt(P);
    if (llt.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
    const VectorXd x = llt.solve(g);
    return t * c - 0.5 * t * t * g.dot(x) - 8.0 * kEps * t * size;
  }

  /// The t of the largest leastValue(t), a concave function. Beyond some t there is no least value.
  double bestScale() const {
    return goldenSection([this](double t) { return leastValue(t); }, 0.0, 2.0, 80);
  }
};

ScaledLagrangian lagrangian(const DesignTask& task, const MatrixXd& root, const VectorXd& nu,
                            double reward) {
  const MatrixXd all = weighted(task.response.factors, root);
  ScaledLagrangian l;
  l.G = -2.0 * all.transpose() * all;
  l.g = VectorXd::Zero(all.cols());
  l.c = reward;
  l.size = std::abs(reward);
  if (!task.response.homogeneous()) {
    const VectorXd start = weighted({task.response.offset}, root);
    l.g = -2.0 * all.transpose() * start;
    l.c -= start.squaredNorm();
    l.size += start.squaredNorm();
  }
  for (Index k = 0; k < nu.size(); ++k) {
    const PeakConstraint& peak = task.peaks[static_cast<std::size_t>(k)];
    const double weight = nu(k) / (peak.limit * peak.limit);
    l.G += weight * peak.rows.transpose() * peak.rows;
    l.g += weight * peak.rows.transpose() * peak.offset;
    l.c += 0.5 * (weight * peak.offset.squaredNorm() - nu(k));
    l.size += nu(k);
  }
  return l;
}

}  // namespace

VectorXd AmplitudeMap::toAmplitudes(const VectorXd& b) const {
  VectorXd a = shape.size() > 0 ? VectorXd(shape * b) : b;
  if (centre.size() > 0) a += centre;
  return a;
}

VectorXd AmplitudeMap::toNormalised(const VectorXd& a) const {
  const VectorXd moved = centre.size() > 0 ? VectorXd(a - centre) : a;
  if (shape.size() == 0) return moved;
  return shape.triangularView<Eigen::Upper>().solve(moved);
}

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

double DesignTask::informationRatio(const VectorXd& b) const {
  if (required.size() == 0) return response.lambdaMin(b) / gamma_w;
  const MatrixXd F = response.factor(b);
  if (F.rows() < F.cols()) return 0.0;
  const MatrixXd R = quad_support::triangularFactor(F);
  if (!(R.diagonal().cwiseAbs().minCoeff() > 0.0)) return 0.0;
  // `required` is a projection P, so P ⪯ N/ρ is ‖R⁻ᵀP‖² ≤ 1/ρ.
  const MatrixXd spread = R.triangularView<Eigen::Upper>().transpose().solve(required);
  const double largest = quad_support::singularValues(spread)(0);
  return 1.0 / (gamma_w * largest * largest);
}

double DesignTask::cost(const VectorXd& direction) const {
  if (!direction.allFinite()) return std::numeric_limits<double>::infinity();
  if (!response.homogeneous()) {
    const VectorXd b = onBoundary(direction);
    return b.size() > 0 ? costAt(b) : std::numeric_limits<double>::infinity();
  }
  if (!excites(direction)) return std::numeric_limits<double>::infinity();
  return std::sqrt(gamma_w / response.lambdaMin(direction)) * direction.norm();
}

VectorXd DesignTask::onBoundary(const VectorXd& direction) const {
  constexpr double kUp = 1.0 + 4e-16;
  if (response.homogeneous()) {
    VectorXd a = direction * std::sqrt(gamma_w / response.lambdaMin(direction));
    for (int i = 0; i < 50 && response.lambdaMin(a) < gamma_w; ++i) a *= kUp + i * 1e-15;
    return a;
  }
  const auto inside = [&](double t) { return response.lambdaMin(t * direction) >= gamma_w; };
  double high = 1.0, factor = 1.0 + 1e-12;
  while (!inside(high)) {
    high *= factor;
    factor = std::min(factor * factor, 8.0);
    if (!(high < 1e12)) return {};
  }
  double low = high, down = 1.0 - 1e-9;
  while (inside(low)) {
    high = low;
    low *= down;
    down = std::max(down * down, 0.125);
    if (low < 1e-12) return excites(0.0 * direction) ? VectorXd(0.0 * direction) : VectorXd();
  }
  while (high - low > 4e-16 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (inside(middle) ? high : low) = middle;
  }
  const VectorXd b = high * direction;
  return excites(b) ? b : VectorXd();
}

Certificate DesignTask::certify(const MatrixXd& root, const VectorXd& nu) const {
  const Certificate nothing{MatrixXd::Zero(root.rows(), 1), 0.0, 0.0 * nu};
  if (root.size() == 0 || !root.allFinite()) return nothing;
  Certificate certificate{root, 0.0, nu.cwiseMax(0.0)};
  const double reward = gamma_w * (required.size() > 0 ? (required * root).cwiseProduct(root).sum()
                                                       : root.squaredNorm());
  if (response.homogeneous() && nu.size() == 0) {
    const double largest = largestEigenvalue(response, root);
    const double square = reward / largest;
    if (!(largest > 0.0) || !std::isfinite(square) || !(square > 0.0)) return nothing;
    certificate.root /= std::sqrt(2.0 * largest);  // the multiplier of ½‖a‖²: 2 λ_max(H(Z)) = 1
    certificate.bound = std::sqrt(square) * (1.0 - 1e-13);
    return certificate;
  }
  const ScaledLagrangian l = lagrangian(*this, root, certificate.nu, reward);
  const double t = l.bestScale();
  const double square = 2.0 * l.leastValue(t) + map.floor;
  if (!(square > 0.0) || !std::isfinite(square)) return nothing;
  certificate.root *= std::sqrt(t);
  certificate.nu *= t;
  certificate.bound = std::sqrt(square) * (1.0 - 1e-13);
  return certificate;
}

MatrixXd DesignTask::table(const VectorXd& b) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Index p = b.size() / runs;
  VectorXd a(b.size());
  for (int i = 0; i < runs; ++i)
    a.segment(i * p, p) =
        map.toAmplitudes(std::sqrt(static_cast<double>(runs)) * b.segment(i * p, p));
  return Eigen::Map<const RowMajor>(a.data(), a.size() / num_inputs, num_inputs);
}

VectorXd DesignTask::components(const MatrixXd& table) const {
  const VectorXd a = table.reshaped<Eigen::RowMajor>();
  const Index p = a.size() / runs;
  VectorXd b(a.size());
  for (int i = 0; i < runs; ++i)
    b.segment(i * p, p) =
        map.toNormalised(a.segment(i * p, p)) / std::sqrt(static_cast<double>(runs));
  return b;
}

DesignTask DesignTask::replicated(int r) const {
  if (r == 1) return *this;
  DesignTask task = *this;
  task.runs = r;
  task.response.factors.clear();
  const Index rows = response.factors.front().rows(), n = response.size();
  for (int i = 0; i < r; ++i) {
    for (const MatrixXd& F : response.factors) {
      MatrixXd tall = MatrixXd::Zero(r * rows, n);
      tall.middleRows(i * rows, rows) = F;
      task.response.factors.push_back(std::move(tall));
    }
  }
  if (!response.homogeneous())
    task.response.offset = response.offset.replicate(r, 1) / std::sqrt(static_cast<double>(r));
  return task;
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
