#include "constraint_shape.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/KroneckerProduct>

#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSingular = 1e-14;  // of the largest eigenvalue: zero
constexpr double kFloor = 1e-6;      // asked for where D_des is zero, of its largest eigenvalue

bool isUnknown(const ExplorationProblem& problem, int row, int regressor) {
  return problem.known.size() == 0 || std::isnan(problem.known(row, regressor));
}

/// The sets of regressors unknown in some row of Θ that lie in no other such set, and such a row.
void unknownSets(const ExplorationProblem& problem, std::vector<std::vector<int>>& sets,
                 std::vector<int>& rows) {
  for (int i = 0; i < problem.numStates(); ++i) {
    std::vector<int> set;
    for (int j = 0; j < problem.numRegressors(); ++j) {
      if (isUnknown(problem, i, j)) set.push_back(j);
    }
    if (set.empty()) continue;
    const auto within = [&set](const std::vector<int>& other) {
      return std::includes(other.begin(), other.end(), set.begin(), set.end());
    };
    if (std::any_of(sets.begin(), sets.end(), within)) continue;
    for (std::size_t s = sets.size(); s-- > 0;) {
      if (!std::includes(set.begin(), set.end(), sets[s].begin(), sets[s].end())) continue;
      sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(s));
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(s));
    }
    sets.push_back(set);
    rows.push_back(i);
  }
}

MatrixXd grown(const MatrixXd& m, const MatrixXd& block) {
  MatrixXd out = MatrixXd::Zero(m.rows() + block.rows(), m.cols() + block.cols());
  out.topLeftCorner(m.rows(), m.cols()) = m;
  out.bottomRightCorner(block.rows(), block.cols()) = block;
  return out;
}

}  // namespace

ConstraintShape::ConstraintShape(const ExplorationProblem& problem)
    : num_states_(problem.numStates()),
      num_regressors_(problem.numRegressors()),
      full_(problem.D_des.rows() != 1 && problem.D_des.rows() != problem.numRegressors()),
      known_(problem.known.size() > 0) {
  const double largest = quad_support::symmetricEigenvalues(problem.D_des).tail(1)(0);
  if (full_) {
    for (int j = 0; j < num_regressors_; ++j) {
      for (int i = 0; i < num_states_; ++i) {
        if (isUnknown(problem, i, j)) entries_.push_back(j * num_states_ + i);
      }
    }
    add(problem.D_des(entries_, entries_), largest);
    return;
  }
  unknownSets(problem, sets_, rows_);
  const MatrixXd D =
      problem.D_des.size() == 1
          ? MatrixXd(problem.D_des(0, 0) * MatrixXd::Identity(num_regressors_, num_regressors_))
          : problem.D_des;
  for (const std::vector<int>& set : sets_) add(D(set, set), largest);
}

void ConstraintShape::add(const MatrixXd& D, double largest) {
  const quad_support::SymmetricEigen eigen(D);
  const VectorXd floored =
      (eigen.values.array() > kSingular * largest).select(eigen.values, kFloor * largest);
  const MatrixXd root =
      eigen.vectors * floored.cwiseSqrt().cwiseInverse().asDiagonal() * eigen.vectors.transpose();
  const VectorXd kept = (eigen.values.array() > kSingular * largest)
                            .select(VectorXd::Ones(D.rows()), VectorXd::Zero(D.rows()));
  root_ = grown(root_, 0.5 * (root + root.transpose()));
  required_ = grown(required_,
                    kept.minCoeff() > 0.0
                        ? MatrixXd(MatrixXd::Identity(D.rows(), D.rows()))
                        : MatrixXd(eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose()));
}

MatrixXd ConstraintShape::factor(const MatrixXd& regressors) const {
  if (full_) {
    const MatrixXd all =
        Eigen::kroneckerProduct(regressors, MatrixXd::Identity(num_states_, num_states_));
    return all(Eigen::all, entries_) * root_;
  }
  if (!known_) return regressors * root_;
  MatrixXd F;
  for (const std::vector<int>& set : sets_) F = grown(F, regressors(Eigen::all, set));
  return F * root_;
}

MatrixXd ConstraintShape::multiplierRoot(const MatrixXd& Y) const {
  const MatrixXd WY = root_ * Y;
  if (!full_ && !known_) return WY;
  const Index n = Index{num_regressors_} * num_states_, columns = Y.cols();
  if (full_) {
    MatrixXd all = MatrixXd::Zero(n, columns);
    all(entries_, Eigen::all) = WY;
    return all;
  }
  // N is block diagonal, so only the diagonal blocks of Y Yᵀ count: each has columns of its own.
  MatrixXd all = MatrixXd::Zero(n, columns * static_cast<Index>(sets_.size()));
  Index row = 0;
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    for (const int j : sets_[s])
      all.row(j * num_states_ + rows_[s]).segment(static_cast<Index>(s) * columns, columns) =
          WY.row(row++);
  }
  return all;
}

}  // namespace explore_opt
