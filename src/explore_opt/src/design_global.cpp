#include <fmt/core.h>

#include <cmath>

#include "design_tools.hpp"
#include "dual_bound.hpp"
#include "factor_program.hpp"
#include "ipopt_solver.hpp"
#include "quad_support/interrupt.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDualGap =
    1e-9;  // of ½γ_e²; what the polished multipliers cannot improve is left to them
constexpr double kSolverTolerance = 1e-10;
constexpr int kSolverIterations = 150;
constexpr double kKktTolerance = 1e-6;
constexpr int kRoundings = 32;

/// One local solution: feasible amplitudes on the boundary, multiplier, whether both satisfy the
/// KKT conditions.
struct LocalSolution {
  VectorXd amplitudes;
  MatrixXd Z;
  bool optimal = false;
};

/// a = 2 H(Z) a, Z ⪰ 0, tr Z (N(a) - γ_w I) = 0, each to 1e-6 of its size: judged from the data,
/// not by the solver.
bool satisfiesKkt(const DesignTask& task, const VectorXd& a, const MatrixXd& Z) {
  const double energy = a.squaredNorm();
  const VectorXd stationarity = a - 2.0 * task.response.gramOf(Z) * a;
  const double least = quad_support::symmetricEigenvalues(Z)(0);
  const double complementarity =
      Z.cwiseProduct(task.response.information(a)).sum() - task.gamma_w * Z.trace();
  return stationarity.norm() <= kKktTolerance * a.norm() &&
         least >= -kKktTolerance * std::abs(Z.trace()) &&
         std::abs(complementarity) <= kKktTolerance * energy;
}

/// Runs the factor program from (1 + margin) times `start`, a boundary point; `Z` warm-starts the
/// multipliers.
LocalSolution polish(const DesignTask& task, IpoptSolver& solver, const VectorXd& start,
                     double margin, const MatrixXd* Z) {
  const QuadraticProgram scaled(task.response, task.gamma_w, start);
  FactorProgram program(scaled);
  SolverStart from;
  from.x = program.startAt((1.0 + margin) * scaled.toScaled(start));
  if (Z != nullptr) from.multipliers = program.multipliersOf(scaled.fromCertificate(*Z));
  const SolverAnswer answer = solver.solve(program, from);
  LocalSolution solution{start, MatrixXd::Zero(scaled.size(), scaled.size()), false};
  if (answer.status == SolverStatus::kFailed) return solution;
  const VectorXd a = scaled.toAmplitudes(program.amplitudesOf(answer.x));
  if (!task.excites(a)) return solution;
  solution.amplitudes = task.onBoundary(a);
  solution.Z = scaled.toCertificate(program.certificateOf(answer.multipliers));
  solution.optimal = satisfiesKkt(task, solution.amplitudes, solution.Z);
  return solution;
}

/// The cheapest of: `fallback`, the leading eigenvector of 𝒜, and random vectors with covariance 𝒜.
VectorXd roundLifted(const DesignTask& task, const QuadraticProgram& scaled, const MatrixXd& lifted,
                     const VectorXd& fallback, std::uint64_t seed) {
  const quad_support::SymmetricEigen eigen(lifted);
  const VectorXd roots = eigen.values.cwiseMax(0.0).cwiseSqrt();
  const auto p = roots.size();
  VectorXd best = fallback;
  double least = task.cost(fallback);
  for (int i = 0; i <= kRoundings; ++i) {
    const VectorXd weights =
        i == 0 ? VectorXd(VectorXd::Unit(p, p - 1))
               : VectorXd(roots.cwiseProduct(randomDirection(task, seed, 1000 + i)));
    const VectorXd direction = scaled.toAmplitudes(eigen.vectors * weights);
    const double cost = task.cost(direction);
    if (cost < least) {
      least = cost;
      best = task.onBoundary(direction);
    }
    if (i == 0 && roots(p - 2 < 0 ? 0 : p - 2) < 1e-3 * roots(p - 1))
      break;  // rank one: nothing to round
  }
  return best;
}

/// Collects local solutions: the cheapest amplitudes, the best certificate, one iteration each.
class Search {
 public:
  Search(const DesignTask& task, RawDesign& design) : task_(task), design_(design) {}

  void start(const VectorXd& a) { record(a); }

  void add(const LocalSolution& solution) {
    if (solution.Z.trace() > 0.0) improveCertificate(task_.certify(solution.Z));
    const double now = design_.amplitudes.norm(), candidate = solution.amplitudes.norm();
    const bool cheaper = candidate < now, equal = candidate <= now * (1.0 + 1e-9);
    if (cheaper) record(solution.amplitudes);
    if (equal) optimal_ = solution.optimal || (optimal_ && candidate >= now * (1.0 - 1e-9));
  }

  void improveCertificate(const Certificate& certificate) {
    if (certificate.bound > design_.certificate.bound) design_.certificate = certificate;
  }

  double gap() const { return 1.0 - design_.certificate.bound / design_.amplitudes.norm(); }
  bool optimal() const { return optimal_; }

 private:
  void record(const VectorXd& a) {
    DesignIteration iteration;
    iteration.gamma_e = a.norm();
    iteration.step = design_.iterations.empty() ? 0.0 : (a - design_.amplitudes).norm();
    iteration.amplitudes = task_.table(a);
    design_.iterations.push_back(iteration);
    design_.amplitudes = a;
  }

  const DesignTask& task_;
  RawDesign& design_;
  bool optimal_ = false;
};

void conclude(const Search& search, const DesignOptions& options, RawDesign& design) {
  if (search.gap() <= options.gap_tolerance) {
    design.status = DesignStatus::kSolved;
    design.message = fmt::format("globally optimal to {:.2g} (certified)", search.gap());
  } else if (search.optimal()) {
    design.status = DesignStatus::kSolved;
    design.message =
        fmt::format("best local optimum of {} starts; certified within {:.2g} of the global one",
                    options.random_starts + 1, search.gap());
  } else {
    design.status = DesignStatus::kReducedAccuracy;
    design.message = fmt::format(
        "feasible, certified within {:.2g} of the optimum, but not a KKT point", search.gap());
  }
}

}  // namespace

RawDesign designGlobal(const DesignTask& task, const DesignOptions& options) {
  RawDesign design;
  const auto start = cheapestSimpleDirection(task, options.seed);
  if (!start) {
    design.status = DesignStatus::kNotExciting;
    design.message = "no amplitudes of these lines excite all parameters; add lines or samples";
    return design;
  }
  const QuadraticProgram scaled(task.response, task.gamma_w, *start);
  const DualSolution dual = solveDual(scaled, kDualGap);
  const MatrixXd dual_Z = scaled.toCertificate(dual.Z);

  Search search(task, design);
  search.start(roundLifted(task, scaled, dual.lifted, *start, options.seed));
  search.improveCertificate(task.certify(dual_Z));
  IpoptSolver solver(kSolverTolerance, kSolverIterations);
  const double margin = search.gap() < 1e-4 ? 1e-6 : 0.2;
  search.add(polish(task, solver, design.amplitudes, margin, &dual_Z));
  for (int i = 0; i < options.random_starts && search.gap() > options.gap_tolerance; ++i) {
    quad_support::throwIfInterrupted();
    const VectorXd direction = randomDirection(task, options.seed, static_cast<std::uint64_t>(i));
    if (task.excites(direction))
      search.add(polish(task, solver, task.onBoundary(direction), 0.2, nullptr));
  }
  conclude(search, options, design);
  return design;
}

}  // namespace explore_opt
