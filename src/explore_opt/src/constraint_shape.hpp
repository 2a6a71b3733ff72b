/// In which coordinates the exploration condition is imposed: desired closeness in its three
/// shapes, known entries, singular D_des.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "explore_opt/exploration_problem.hpp"

namespace explore_opt {

/// The condition Eᵀ(Q ⊗ I)E ⪰ γ_w EᵀD_desE, E picking the unknown entries of θ = vec[A B], with the
/// repetitions left out and normalised by W.
///
/// For D_des = D ⊗ I the rows of Θ separate: one block Q[J, J] ⪰ γ_w D[J, J] for each set J of
/// regressors unknown in some row, none for a J within another one. Otherwise one block over all
/// unknown entries.
class ConstraintShape {
 public:
  explicit ConstraintShape(const ExplorationProblem& problem);

  int size() const { return static_cast<int>(root_.rows()); }  ///< n
  const Eigen::MatrixXd& root() const { return root_; }        ///< W
  /// W D W: the identity, or a projection where D_des is singular. What a lower bound may count on.
  const Eigen::MatrixXd& required() const { return required_; }

  /// r x n_φ regressors in rows -> rows of F
  Eigen::MatrixXd factor(const Eigen::MatrixXd& regressors) const;

  /// E W Y, root of the multiplier M = E W Y Yᵀ W Eᵀ of the raw condition: n_φ rows for D ⊗ I
  /// without known entries, else n_φ n_x.
  Eigen::MatrixXd multiplierRoot(const Eigen::MatrixXd& Y) const;

 private:
  void add(const Eigen::MatrixXd& D, double largest);

  int num_states_, num_regressors_;
  bool full_ = false, known_ = false;
  std::vector<std::vector<int>> sets_;  ///< not full: the sets J
  std::vector<int> rows_;               ///< a row of Θ for each
  std::vector<int> entries_;            ///< full: unknown entries of θ
  Eigen::MatrixXd root_, required_;
};

}  // namespace explore_opt
