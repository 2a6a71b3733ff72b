/// Several experiments on one system: what all of them together leave possible.
#pragma once

#include <vector>

#include "explore_opt/set_membership.hpp"

namespace explore_opt {

/// An ellipsoid around the intersection of the sets of several experiments.
struct FusedSet {
  FeasibleSet set;              ///< contains every parameter that lies in all of the sets
  std::vector<double> weights;  ///< λ_j >= 0, Σ λ_j = 1
};

/// Whether the sets together determine every parameter: the condition number of their stacked
/// roots, columns scaled to length one, is at most 1e10. Single ones need not.
bool determineAll(const std::vector<FeasibleSet>& sets);

/// For any weights the intersection lies in { Σ λ_j (distance_j(θ) - G_j) <= 0 }, which is again an
/// ellipsoid. The weights sought make its margin/G largest (margin: informationMargin() of the
/// closeness); whatever the search finds is valid. If some weights give G < 0 the intersection is
/// empty, and those are returned: some γ_w is falsified, though none alone may be.
/// A set whose data leave directions open (see openFit(), openStructuredFit()) is a cylinder; it
/// counts in the others.
/// @param sets  of equal shape, G_j >= 0 or not; at least one; together they must determineAll()
/// @param closeness  as informationMargin(); 1 x 1 for λ(D_bd)
/// @throws quad_support::DataError for none or unequal shapes
FusedSet fuse(const std::vector<FeasibleSet>& sets, const Eigen::MatrixXd& closeness);

/// The ellipsoid of given weights. Centre and root by one QR of the stacked sqrt(λ_j) R_j, centred
/// at the first estimate, so that nothing large cancels.
FeasibleSet fusedWith(const std::vector<FeasibleSet>& sets, const std::vector<double>& weights);

}  // namespace explore_opt
