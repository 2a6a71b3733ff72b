#include "explore_opt/identification.hpp"

#include <algorithm>

#include "checks.hpp"
#include "constants.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

/// What both kinds of fit say before the set is judged.
template <class Fit>
Estimate startEstimate(const DataSet& data, const Fit& fit) {
  Estimate estimate;
  estimate.name = data.name;
  estimate.exciting = fit.exciting;
  estimate.condition = fit.condition;
  estimate.singular_values = fit.singular_values;
  estimate.Theta = fit.Theta;
  estimate.information = fit.information;
  estimate.residual_energy = fit.residual_energy;
  return estimate;
}

/// @param several  other data may determine what these leave open: the set is then a cylinder
Estimate estimateAll(const DataSet& data, bool several) {
  const bool enough = data.U.cols() >= data.X.rows() + data.U.rows();
  LeastSquaresFit fit =
      several && !enough ? openFit(data.X, data.U) : fitLeastSquares(data.X, data.U);
  if (several && enough && !fit.exciting) fit = openFit(data.X, data.U);
  Estimate estimate = startEstimate(data, fit);
  if (fit.exciting) {
    estimate.set = feasibleSet(fit, data.gamma_w);
  } else if (several) {
    estimate.set.center = fit.Theta;
    estimate.set.root = fit.root;
    estimate.set.gamma_w = data.gamma_w;
    estimate.set.G = data.gamma_w - fit.residual_energy;
  }
  return estimate;
}

/// What was not determined by one data set alone but is by all of them.
bool excitingTogether(const Identification& found) {
  const bool each = std::all_of(found.data_sets.begin(), found.data_sets.end(),
                                [](const Estimate& e) { return e.exciting; });
  if (each || found.data_sets.size() == 1) return each;
  std::vector<FeasibleSet> sets;
  for (const Estimate& estimate : found.data_sets) sets.push_back(estimate.set);
  return determineAll(sets);
}

/// Values at the free entries, as one row.
MatrixXd freePart(const MatrixXd& Theta, const std::vector<Entry>& free) {
  MatrixXd row(1, static_cast<Index>(free.size()));
  for (std::size_t e = 0; e < free.size(); ++e)
    row(0, static_cast<Index>(e)) = Theta(free[e].row, free[e].column);
  return row;
}

Estimate estimateStructured(const DataSet& data, const MatrixXd& known, bool several,
                            std::vector<Entry>& free) {
  const bool enough = data.U.cols() * data.X.rows() >= known.array().isNaN().count();
  StructuredFit fit = several && !enough ? openStructuredFit(data.X, data.U, known)
                                         : fitStructured(data.X, data.U, known);
  if (several && enough && !fit.exciting) fit = openStructuredFit(data.X, data.U, known);
  Estimate estimate = startEstimate(data, fit);
  free = fit.free;
  if (!fit.exciting && !several) return estimate;
  const auto n = fit.root.cols();
  estimate.set.center = freePart(fit.Theta, free);
  estimate.set.root = fit.root;
  estimate.set.gamma_w = data.gamma_w;
  estimate.set.G = data.gamma_w - fit.residual_energy;
  if (fit.exciting) estimate.set.lambda_min_S = largestRadius(fit.root, MatrixXd::Identity(n, n));
  return estimate;
}

/// Θ and the coordinates of the set: the same, or with known entries the free ones.
class Coordinates {
 public:
  Coordinates(const MatrixXd& known, const std::vector<Entry>& free, Index nx, Index n)
      : known_(known), free_(free), nx_(nx), n_(n) {}

  bool structured() const { return !free_.empty(); }

  MatrixXd whole(const MatrixXd& center) const {
    if (!structured()) return center;
    MatrixXd Theta = known_;
    for (std::size_t e = 0; e < free_.size(); ++e)
      Theta(free_[e].row, free_[e].column) = center(0, static_cast<Index>(e));
    return Theta;
  }

  AffineFunction restrict(const AffineFunction& f) const {
    if (!structured()) return f;
    const MatrixXd fixed = known_.unaryExpr([](double v) { return std::isnan(v) ? 0.0 : v; });
    return {f.at(fixed), freePart(f.weights, free_)};
  }

  ParameterFunction restrict(const ParameterFunction& f) const {
    ParameterFunction out{f.name, restrict(f.numerator), std::nullopt};
    if (f.denominator) out.denominator = restrict(*f.denominator);
    return out;
  }

  /// @throws DataError if a known entry of the candidate differs
  MatrixXd restrict(const MatrixXd& Theta) const {
    requireShape(Theta, nx_, n_, "the candidate [A B]");
    requireFinite(Theta, "the candidate [A B]");
    if (!structured()) return Theta;
    for (Index j = 0; j < n_; ++j) {
      for (Index i = 0; i < nx_; ++i) {
        require(std::isnan(known_(i, j)) || known_(i, j) == Theta(i, j),
                "the candidate has {} in row {}, column {}, where {} is known", Theta(i, j), i + 1,
                j + 1, known_(i, j));
      }
    }
    return freePart(Theta, free_);
  }

  MatrixXd restrictCloseness(const MatrixXd& closeness, const MatrixXd& Theta) const {
    if (!structured()) return closeness;
    StructuredFit shape;
    shape.free = free_;
    shape.Theta = Theta;
    return explore_opt::restrictCloseness(closeness, shape);
  }

 private:
  const MatrixXd& known_;
  const std::vector<Entry>& free_;
  Index nx_, n_;
};

void addEntryIntervals(const Coordinates& coordinates, Identification& out) {
  const Index nx = out.Theta.rows(), n = out.Theta.cols();
  out.lower.resize(nx, n);
  out.upper.resize(nx, n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < nx; ++i) {
      ParameterFunction entry;
      entry.numerator.weights = MatrixXd::Zero(nx, n);
      entry.numerator.weights(i, j) = 1.0;
      const auto interval = intervalOf(out.set, coordinates.restrict(entry));
      out.lower(i, j) = interval->lower;
      out.upper(i, j) = interval->upper;
    }
  }
}

void addAnswers(const IdentificationRequest& request, const Coordinates& coordinates,
                const std::vector<ParameterFunction>& functions, Identification& out) {
  if (request.closeness) {
    const MatrixXd D = coordinates.restrictCloseness(*request.closeness, out.Theta);
    out.margin =
        coordinates.structured() ? largestRadius(out.set.root, D) : informationMargin(out.set, D);
  }
  if (!out.set.falsified()) addEntryIntervals(coordinates, out);
  for (const ParameterFunction& f : functions)
    out.functions.push_back(intervalOf(out.set, coordinates.restrict(f)));
  if (!request.candidate) return;
  const MatrixXd candidate = coordinates.restrict(*request.candidate);
  out.candidate_distance = distance(out.set, candidate);
  for (const Estimate& e : out.data_sets)
    if (out.data_sets.size() > 1) out.candidate_distances.push_back(distance(e.set, candidate));
}

void fuseEstimates(const IdentificationRequest& request, const Coordinates& coordinates,
                   Identification& out) {
  std::vector<FeasibleSet> sets;
  for (const Estimate& estimate : out.data_sets) sets.push_back(estimate.set);
  if (sets.size() == 1) {
    out.set = sets.front();
    out.information = out.data_sets.front().information;
  } else {
    const MatrixXd D = request.closeness ? coordinates.restrictCloseness(
                                               *request.closeness, out.data_sets.front().Theta)
                                         : MatrixXd::Identity(1, 1);
    const FusedSet fused = fuse(sets, D);
    out.set = fused.set;
    out.weights = fused.weights;
    out.information = out.set.root.transpose() * out.set.root;
  }
  out.Theta = coordinates.whole(out.set.center);
}

}  // namespace

bool Identification::candidateIsMember(std::size_t data_set) const {
  const FeasibleSet& one = data_sets[data_set].set;
  return !one.falsified() && candidate_distances[data_set] <= one.G + 1e-10 * one.gamma_w;
}

bool Identification::candidateIsMember() const {
  for (std::size_t i = 0; i < candidate_distances.size(); ++i)
    if (!candidateIsMember(i)) return false;
  return exciting && candidate_distance && !set.falsified() &&
         *candidate_distance <= set.G + 1e-10 * set.gamma_w;  // as contains()
}

Identification identify(const std::vector<DataSet>& data, const IdentificationRequest& request) {
  require(!data.empty(), "no data");
  const Index nx = data.front().X.rows(), nu = data.front().U.rows();
  Identification out;
  std::vector<ParameterFunction> functions;
  for (const std::string& text : request.functions) {
    functions.push_back(parseFunction(text, static_cast<int>(nx), static_cast<int>(nu)));
    out.function_names.push_back(functions.back().name);
  }
  if (request.closeness)
    fullCloseness(*request.closeness, static_cast<int>(nx), static_cast<int>(nx + nu));
  for (const DataSet& set : data) {
    requirePositive(set.gamma_w, "gamma_w");
    require(set.X.rows() == nx && set.U.rows() == nu,
            "{} has {} states and {} inputs, the first data set {} and {}", set.name, set.X.rows(),
            set.U.rows(), nx, nu);
    out.data_sets.push_back(withName(set.name, [&] {
      return request.known.size() > 0
                 ? estimateStructured(set, request.known, data.size() > 1, out.free)
                 : estimateAll(set, data.size() > 1);
    }));
  }
  const Coordinates coordinates(request.known, out.free, nx, nx + nu);
  if (request.candidate) coordinates.restrict(*request.candidate);  // checks it
  out.exciting = excitingTogether(out);
  if (!out.exciting) {
    if (request.closeness) out.margin = 0.0;
    return out;
  }
  fuseEstimates(request, coordinates, out);
  addAnswers(request, coordinates, functions, out);
  return out;
}

namespace {

std::string notDetermined(const Identification& v) {
  if (v.data_sets.size() > 1) {
    return fmt::format(
        "the {} data sets do not determine {}, not even together; excite what each leaves open",
        v.data_sets.size(), v.free.empty() ? "[A B]" : "the unknown entries");
  }
  const Estimate& e = v.data_sets.front();
  return fmt::format(
      "{}: the data do not determine [A B]: condition {:.3g} of the scaled regressor, smallest "
      "singular value {:.3g}; excite more",
      e.name, e.condition, e.singular_values.tail(1)(0));
}

std::string falsifiedBy(const Identification& v) {
  const bool alone = v.data_sets.size() == 1;
  for (const Estimate& e : v.data_sets) {
    if (alone || !e.set.falsified()) continue;
    return fmt::format(
        "{}: gamma_w = {} is smaller than the residual energy, so G = {:.6g} < 0 and no parameter "
        "fits this data set (Eq. 1.8). Raise its --gamma-w or look at the data",
        e.name, e.set.gamma_w, e.set.G);
  }
  if (!v.falsified()) return {};
  if (!alone) {
    return fmt::format(
        "the data sets contradict one another: no parameter lies in all of their sets (G = {:.6g} "
        "< 0 for the weights given). One of the gamma_w is too small, or the system changed",
        v.set.G);
  }
  return fmt::format(
      "{}: gamma_w = {} is smaller than the residual energy {:.6g}, so G = {:.6g} < 0 and no "
      "parameter fits the data (Eq. 1.8). Raise --gamma-w or look at the data",
      v.data_sets.front().name, v.set.gamma_w, v.data_sets.front().residual_energy, v.set.G);
}

std::string candidateIsOutside(const Identification& v) {
  for (std::size_t i = 0; i < v.candidate_distances.size(); ++i) {
    if (v.candidateIsMember(i)) continue;
    return fmt::format(
        "the candidate [A B] is not among the parameters that {} leaves possible: distance {:.6g}, "
        "G = {:.6g} (Eq. 1.7)",
        v.data_sets[i].name, v.candidate_distances[i], v.data_sets[i].set.G);
  }
  if (!v.candidate_distance || v.candidateIsMember()) return {};
  return fmt::format(
      "the candidate [A B] is not among the parameters the data leave possible: "
      "distance {:.6g}, G = {:.6g} (Eq. 1.7)",
      *v.candidate_distance, v.set.G);
}

}  // namespace

std::string complaint(const Identification& v) {
  if (!v.exciting) return notDetermined(v);
  const std::string falsified = falsifiedBy(v);
  if (!falsified.empty()) return falsified;
  if (v.margin && !v.conditionMet()) {
    return fmt::format(
        "exploration condition not met: the data guarantee the desired closeness for G <= {:.6g}, "
        "but G = {:.6g} (Eq. 1.10)",
        *v.margin, v.set.G);
  }
  return candidateIsOutside(v);
}

}  // namespace explore_opt
