#include "explore_opt/fusion.hpp"

#include <Eigen/QR>
#include <cmath>
#include <functional>
#include <limits>

#include "checks.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSweeps = 12;

using Weights = std::vector<double>;
using Score = std::function<double(const Weights&)>;

/// Golden section along the exchange of weight between two sets; the score is quasi-concave.
void exchange(const Score& score, std::size_t a, std::size_t b, Weights& weights, double& best) {
  const double both = weights[a] + weights[b];
  const auto scoreAt = [&](double part) {
    Weights trial = weights;
    trial[a] = part * both;
    trial[b] = (1.0 - part) * both;
    return score(trial);
  };
  constexpr double kGolden = 0.61803398874989485;
  double low = 0.0, high = 1.0, left = 1.0 - kGolden, right = kGolden;
  double at_left = scoreAt(left), at_right = scoreAt(right);
  for (int i = 0; i < 40; ++i) {
    if (at_left >= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = scoreAt(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = scoreAt(right);
    }
  }
  for (const double part : {0.0, 1.0, 0.5 * (low + high)}) {
    const double value = scoreAt(part);
    if (value <= best) continue;
    best = value;
    weights[a] = part * both;
    weights[b] = both - weights[a];
  }
}

Weights maximise(const Score& score, Weights weights) {
  double best = score(weights);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double before = best;
    for (std::size_t a = 0; a < weights.size(); ++a) {
      for (std::size_t b = a + 1; b < weights.size(); ++b) exchange(score, a, b, weights, best);
    }
    if (!(best > before + 1e-9 * std::abs(before))) break;
  }
  return weights;
}

}  // namespace

FeasibleSet fusedWith(const std::vector<FeasibleSet>& sets, const std::vector<double>& weights) {
  require(!sets.empty() && sets.size() == weights.size(), "{} sets and {} weights", sets.size(),
          weights.size());
  const MatrixXd& centre = sets.front().center;
  const Index n = centre.cols(), nx = centre.rows();
  // Rows sqrt(λ_j) [R_j, R_j (Θ̂_j - Θ̂_1)ᵀ]; the triangle holds root, solution and residual.
  MatrixXd stacked(static_cast<Index>(sets.size()) * n, n + nx);
  FeasibleSet fused;
  for (std::size_t j = 0; j < sets.size(); ++j) {
    requireShape(sets[j].center, nx, n, "a data set's estimate");
    const double root = std::sqrt(weights[j]);
    const auto row = static_cast<Index>(j) * n;
    stacked.block(row, 0, n, n) = root * sets[j].root;
    stacked.block(row, n, n, nx) = root * sets[j].root * (sets[j].center - centre).transpose();
    fused.G += weights[j] * sets[j].G;
    fused.gamma_w += weights[j] * sets[j].gamma_w;
  }
  const Eigen::HouseholderQR<MatrixXd> qr(stacked.leftCols(n));
  fused.root = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  const MatrixXd rotated = qr.householderQ().transpose() * stacked.rightCols(nx);
  fused.center =
      centre + fused.root.triangularView<Eigen::Upper>().solve(rotated.topRows(n)).transpose();
  fused.G -= rotated.bottomRows(rotated.rows() - n).squaredNorm();
  const double sigma = quad_support::singularValues(fused.root).tail(1)(0);
  fused.lambda_min_S = sigma * sigma;
  return fused;
}

FusedSet fuse(const std::vector<FeasibleSet>& sets, const MatrixXd& closeness) {
  require(!sets.empty(), "no data set to fuse");
  const Weights equal(sets.size(), 1.0 / static_cast<double>(sets.size()));
  const auto emptiness = [&](const Weights& w) { return -fusedWith(sets, w).G; };
  const Weights emptiest = maximise(emptiness, equal);
  if (emptiness(emptiest) > 0.0) return {fusedWith(sets, emptiest), emptiest};
  const auto precision = [&](const Weights& w) {
    const FeasibleSet set = fusedWith(sets, w);
    return set.G > 0.0 ? informationMargin(set, closeness) / set.G : kInfinity;
  };
  const Weights best = maximise(precision, equal);
  return {fusedWith(sets, best), best};
}

}  // namespace explore_opt
