/// Which parameters the data leave possible when the disturbance's energy is bounded; Eqs. (1.7) to
/// (1.11).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "explore_opt/least_squares.hpp"

namespace explore_opt {

/// The set {θ : (θ-θ̂)ᵀ (S ⊗ I) (θ-θ̂) <= G} of Eq. (1.7).
struct FeasibleSet {
  Eigen::MatrixXd center;     ///< Θ̂, n_x x n_φ
  Eigen::MatrixXd root;       ///< R with RᵀR = S
  double gamma_w = 0.0;       ///< the assumed bound of Eq. (1.6)
  double G = 0.0;             ///< γ_w - residual energy; below zero no parameter fits
  double lambda_min_S = 0.0;  ///< smallest eigenvalue of S

  /// The data contradict γ_w (or linearity): the set is empty. False proves nothing: noise may hide
  /// in the fit.
  bool falsified() const { return G < 0.0; }
  /// λ(D_bd) = λ_min(S)/G; none if G <= 0. It *grows* when the residual eats up γ_w: compare it
  /// between experiments only where γ_w is known to hold.
  std::optional<double> lambdaBound() const;
};

/// Eq. (1.8). For the least-squares estimate G = γ_w - residual energy, which does not subtract two
/// large numbers.
/// @throws quad_support::DataError if the fit is not exciting or γ_w is not positive and finite
FeasibleSet feasibleSet(const LeastSquaresFit& fit, double gamma_w);

/// (θ-θ̂)ᵀ (S ⊗ I) (θ-θ̂), to be compared with G. @throws quad_support::DataError for wrong shapes
double distance(const FeasibleSet& set, const Eigen::MatrixXd& Theta);

/// Whether Θ is among the parameters the data leave possible (a boundary point, to 1e-10 γ_w, is).
bool contains(const FeasibleSet& set, const Eigen::MatrixXd& Theta);

/// @throws quad_support::DataError for a D that is not finite, not square, not symmetric (to 1e-12)
/// or has a negative eigenvalue
void requireCloseness(const Eigen::MatrixXd& D, const char* name = "D");

/// A desired closeness by its shape: 1 x 1 means λ I, n_φ x n_φ means D ⊗ I, n_φ n_x x n_φ n_x is
/// taken as it stands.
/// @returns the full matrix, size n_φ n_x (columns of Θ stacked)
/// @throws quad_support::DataError for other shapes, not symmetric, not finite
Eigen::MatrixXd fullCloseness(const Eigen::MatrixXd& closeness, int num_states, int num_regressors);

/// The largest G with S ⊗ I ⪰ G D: λ_min(D^{-1/2} (S ⊗ I) D^{-1/2}) for D ≻ 0, and right for
/// singular D ⪰ 0 too (infinite for D = 0). @param closeness  as fullCloseness(); must be positive
/// semidefinite
double informationMargin(const FeasibleSet& set, const Eigen::MatrixXd& closeness);

/// The largest G with RᵀR ⪰ G D, for any information matrix RᵀR and D of its size (structured fits,
/// say).
/// @param root  R, square, upper triangular, nonsingular
double largestRadius(const Eigen::MatrixXd& root, const Eigen::MatrixXd& closeness);

/// Eq. (1.10), P_θ⁻¹ ⪰ G D_des with G >= 0: sufficient for (1.9). False if γ_w is falsified.
bool explorationCondition(const FeasibleSet& set, const Eigen::MatrixXd& closeness);

/// Left side of (1.9): (θ_true - θ̂)ᵀ D_des (θ_true - θ̂). Needs the truth: only in simulation.
double explorationObjective(const Eigen::MatrixXd& theta_true,
                            const Eigen::MatrixXd& theta_estimate,
                            const Eigen::MatrixXd& closeness);

/// λ(D_Texp) = 1/‖vec(Θ̂ - Θ_true)‖², thesis section 3.2.2; infinite if they are equal.
double closenessOfFit(const Eigen::MatrixXd& theta_true, const Eigen::MatrixXd& theta_estimate);

/// The chain D_Texp⁻¹ ⪯ D_bd⁻¹ ⪯ D_des⁻¹ ⪯ D_init⁻¹ of thesis section 3.2.2, each link on its own.
struct ClosenessChain {
  bool truth_within_bound = false;      ///< e eᵀ ⪯ G P_θ, i.e. the truth is in the set
  bool bound_within_desired = false;    ///< G P_θ ⪯ D_des⁻¹, Eq. (1.10)
  bool desired_within_initial = false;  ///< D_des⁻¹ ⪯ D_init⁻¹
  bool holds() const {
    return truth_within_bound && bound_within_desired && desired_within_initial;
  }
};

/// @param desired, initial  D_des, D_init as in fullCloseness()
ClosenessChain judgeChain(const FeasibleSet& set, const Eigen::MatrixXd& theta_true,
                          const Eigen::MatrixXd& desired, const Eigen::MatrixXd& initial);

}  // namespace explore_opt
