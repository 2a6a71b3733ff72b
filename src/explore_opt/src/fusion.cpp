#include "explore_opt/fusion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "checks.hpp"
#include "constants.hpp"
#include "golden_section.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

constexpr int kSweeps = 12;
constexpr double kLeastPart = 1e-6;  // so that sets which only together determine all do

using Weights = std::vector<double>;
using Score = std::function<double(const Weights&)>;

/// Golden section along the exchange of weight between two sets; the score is quasi-concave.
/// @param least  part of their weight that each of the two keeps
void exchange(const Score& score, double least, std::size_t a, std::size_t b, Weights& weights,
              double& best) {
  const double both = weights[a] + weights[b];
  const auto scoreAt = [&](double part) {
    Weights trial = weights;
    trial[a] = part * both;
    trial[b] = (1.0 - part) * both;
    return score(trial);
  };
  const double inside = goldenSection(scoreAt, least, 1.0 - least, 40);
  for (const double part : {least, 1.0 - least, inside}) {
    const double value = scoreAt(part);
    if (value <= best) continue;
    best = value;
    weights[a] = part * both;
    weights[b] = both - weights[a];
  }
}

Weights maximise(const Score& score, double least, Weights weights) {
  double best = score(weights);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double before = best;
    for (std::size_t a = 0; a < weights.size(); ++a) {
      for (std::size_t b = a + 1; b < weights.size(); ++b)
        exchange(score, least, a, b, weights, best);
    }
    if (!(best > before + 1e-9 * std::abs(before))) break;
  }
  return weights;
}

/// σ_max/σ_min of a root with its columns scaled to length one.
double conditionOf(const MatrixXd& root) {
  const Eigen::VectorXd lengths = root.colwise().norm();
  if (!(lengths.minCoeff() > 0.0)) return kInfinity;
  const Eigen::VectorXd sigma =
      quad_support::singularValues(root * lengths.cwiseInverse().asDiagonal());
  return sigma(0) / sigma(sigma.size() - 1);
}

}  // namespace

bool determineAll(const std::vector<FeasibleSet>& sets) {
  require(!sets.empty(), "no data set to fuse");
  const Index n = sets.front().root.cols();
  MatrixXd stacked(static_cast<Index>(sets.size()) * n, n);
  for (std::size_t j = 0; j < sets.size(); ++j) {
    requireShape(sets[j].root, n, n, "a data set's root");
    stacked.middleRows(static_cast<Index>(j) * n, n) = sets[j].root;
  }
  return conditionOf(stacked) <= kLargestCondition;
}

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
  const MatrixXd R = quad_support::triangularFactor(stacked);
  fused.root = R.topLeftCorner(n, n);
  const MatrixXd rotated = R.rightCols(nx);
  fused.center =
      centre + fused.root.triangularView<Eigen::Upper>().solve(rotated.topRows(n)).transpose();
  fused.G -= rotated.bottomRows(R.rows() - n).squaredNorm();
  const double sigma = quad_support::singularValues(fused.root).tail(1)(0);
  fused.lambda_min_S = sigma * sigma;
  return fused;
}

FusedSet fuse(const std::vector<FeasibleSet>& sets, const MatrixXd& closeness) {
  require(!sets.empty(), "no data set to fuse");
  require(determineAll(sets), "the data sets do not determine all parameters, not even together");
  const Weights equal(sets.size(), 1.0 / static_cast<double>(sets.size()));
  const bool each = std::all_of(sets.begin(), sets.end(), [](const FeasibleSet& set) {
    return conditionOf(set.root) <= kLargestCondition;
  });
  const double least = each ? 0.0 : kLeastPart;
  const auto emptiness = [&](const Weights& w) { return -fusedWith(sets, w).G; };
  const Weights emptiest = maximise(emptiness, least, equal);
  if (emptiness(emptiest) > 0.0) return {fusedWith(sets, emptiest), emptiest};
  const auto precision = [&](const Weights& w) {
    const FeasibleSet set = fusedWith(sets, w);
    return set.G > 0.0 ? informationMargin(set, closeness) / set.G : kInfinity;
  };
  const Weights best = maximise(precision, least, equal);
  return {fusedWith(sets, best), best};
}

}  // namespace explore_opt
