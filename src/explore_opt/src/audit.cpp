// Plain on purpose: a reader should be able to check this file by eye. It uses Eigen, the problem's
// fields, and nothing of the design code.
#include "explore_opt/audit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "quad_support/interrupt.hpp"

namespace explore_opt {
namespace {

using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Eigen::Index;

constexpr Real kFullTurn = 6.283185307179586476925286766559005768L;

/// R with RᵀR = ΦΦᵀ, sample by sample. The products themselves would lose the square of what
/// Φ's condition number costs.
class Triangle {
 public:
  explicit Triangle(Index n) : rows_(Matrix::Zero(kRows + n, n)), next_(n) {}

  void add(const Vector& phi) {
    rows_.row(next_++) = phi.transpose();
    if (next_ == rows_.rows()) reduce();
  }
  /// Changes nothing but the form.
  Matrix root() {
    reduce();
    return rows_.topRows(rows_.cols());
  }

 private:
  static constexpr Index kRows = 32;

  void reduce() {
    const Eigen::HouseholderQR<Matrix> qr(rows_);
    const Index n = rows_.cols();
    rows_.setZero();
    rows_.topRows(n) = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    next_ = n;
  }

  Matrix rows_;
  Index next_;
};

/// Problem in long double, and the sums over all samples that the checks need. Column a < p of a
/// sample's regressors answers unit amplitude of component a, column p answers x_0.
struct Sums {
  const ExplorationProblem& problem;
  int p;
  Matrix D, weight;            // D_des of full meaning, D or D ⊗ I; Σ M-weighted products
  Matrix cost;                 // γ_e² = [a; 1]ᵀ cost [a; 1] (one experiment)
  Matrix peaks;                // Σ ν_k [a; 1]ᵀ peaks [a; 1] = Σ ν_k ‖u_k‖²
  Real peak_limits = 0.0L;     // Σ ν_k u_max²
  std::vector<Triangle> data;  // of each experiment
  std::vector<Real> energy;    // Σ‖u_k‖² of each experiment
  Vector largest_inputs;       // largest |u_kj|, and last ‖u_k‖, of all
};

Real carrier(const ExplorationProblem& problem, int row, int k) {
  const SpectralLines& lines = problem.lines;
  const int L = lines.size(), i = row % L;
  const bool sine = problem.phase == Phase::kSin || row >= L;
  const auto at = static_cast<std::size_t>(i);
  const Real turns =
      lines.harmonics.empty()
          ? std::fmod(Real(lines.frequencies[at]) * k, 1.0L)
          : Real(std::int64_t{lines.harmonics[at]} * k % lines.num_samples) / lines.num_samples;
  return sine ? std::sin(kFullTurn * turns) : std::cos(kFullTurn * turns);
}

/// D_des as it is meant: λ I and D ⊗ I stay n_φ x n_φ, unless entries are known.
Matrix meaning(const ExplorationProblem& problem) {
  const Index n = problem.numRegressors();
  Matrix D = problem.D_des.cast<Real>();
  if (D.size() == 1) D = (D(0, 0) * Matrix::Identity(n, n)).eval();
  return D;
}

/// S ⊗ I.
Matrix expanded(const Matrix& S, Index nx) {
  Matrix out = Matrix::Zero(S.rows() * nx, S.cols() * nx);
  for (Index i = 0; i < S.rows(); ++i)
    for (Index j = 0; j < S.cols(); ++j)
      for (Index k = 0; k < nx; ++k) out(i * nx + k, j * nx + k) = S(i, j);
  return out;
}

/// V with tr(Y Yᵀ(φφᵀ [⊗ I])) = ‖V φ‖²: Yᵀ, or each column of Y as n_x rows.
Matrix weights(const Matrix& Y, Index n, Index nx) {
  if (Y.rows() == n) return Y.transpose();
  Matrix V(Y.cols() * nx, n);
  for (Index r = 0; r < Y.cols(); ++r)
    for (Index j = 0; j < n; ++j) V.col(j).segment(r * nx, nx) = Y.col(r).segment(j * nx, nx);
  return V;
}

/// Y with Y Yᵀ the positive part of M.
Matrix positiveRoot(const Matrix& M) {
  const Matrix symmetric = 0.5L * (M + M.transpose());
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0L).cwiseSqrt().asDiagonal();
}

/// M = D^{-1/2} Z D^{-1/2} of a normalised certificate.
Matrix rawMultiplier(const Matrix& Z, const Matrix& D) {
  const Matrix root = Eigen::SelfAdjointEigenSolver<Matrix>(D).operatorInverseSqrt();
  return root * Z * root;
}

/// Simulates all unit responses at once, sample by sample, and adds up what is needed.
Sums simulate(const ExplorationProblem& problem, const Matrix& Y, const DesignClaims& claims) {
  const int p = problem.numAmplitudes(), nx = problem.numStates(), nu = problem.numInputs(),
            n = nx + nu, carriers = p / nu;
  const auto runs = static_cast<int>(claims.amplitudes.rows() / carriers);
  const Matrix A = problem.A.cast<Real>(), B = problem.B.cast<Real>();
  Matrix chosen = Matrix::Zero(p + 1, runs);  // [a; 1] of each experiment
  for (int r = 0; r < runs; ++r)
    for (int a = 0; a < p; ++a) chosen(a, r) = claims.amplitudes(r * carriers + a / nu, a % nu);
  chosen.row(p).setOnes();

  const Matrix V = weights(Y, n, nx);
  Sums s{problem,
         p,
         meaning(problem),
         Matrix::Zero(p + 1, p + 1),
         Matrix::Zero(p + 1, p + 1),
         Matrix::Zero(p + 1, p + 1),
         0.0L,
         std::vector<Triangle>(static_cast<std::size_t>(runs), Triangle(n)),
         std::vector<Real>(static_cast<std::size_t>(runs), 0.0L),
         Vector::Zero(nu + 1)};
  Matrix X = Matrix::Zero(nx, p + 1), phi(n, p + 1);
  if (problem.x0.size() > 0) X.col(p) = problem.x0.cast<Real>();
  for (int k = 0; k < problem.lines.num_samples; ++k) {
    if (k % 4096 == 0) quad_support::throwIfInterrupted();
    Matrix U = Matrix::Zero(nu, p + 1);
    for (int a = 0; a < p; ++a) U(a % nu, a) = carrier(problem, a / nu, k);
    if (problem.K.size() > 0) U += problem.K.cast<Real>() * X;
    phi << X, U;
    const Matrix weighted = V * phi;
    s.weight += weighted.transpose() * weighted;
    s.cost += U.transpose() * U;
    for (const DesignClaims::Peak& peak : claims.peak_multipliers) {
      if (peak.sample != k) continue;
      const Matrix rows = peak.input < 0 ? U : Matrix(U.row(peak.input));
      const Real limit = problem.u_max(std::max(0, problem.u_max.size() == 1 ? 0 : peak.input));
      s.peaks += std::max<Real>(0.0L, peak.value) * rows.transpose() * rows;
      s.peak_limits += std::max<Real>(0.0L, peak.value) * limit * limit;
    }
    for (int r = 0; r < runs; ++r) {
      const Vector now = phi * chosen.col(r), u = now.tail(nu);
      s.data[static_cast<std::size_t>(r)].add(now);
      s.energy[static_cast<std::size_t>(r)] += u.squaredNorm();
      for (int j = 0; j < nu; ++j)
        s.largest_inputs(j) = std::max(s.largest_inputs(j), std::abs(u(j)));
      s.largest_inputs(nu) = std::max(s.largest_inputs(nu), u.norm());
    }
    X = (A * X + B * U).eval();
  }
  return s;
}

/// Largest ρ with (mean information)[⊗ I] ⪰ ρ γ_w D_des on the unknown entries; 0 if the
/// information is singular.
Real feasibility(Sums& s) {
  const ExplorationProblem& problem = s.problem;
  const Index n = problem.numRegressors(), nx = problem.numStates();
  const auto runs = static_cast<Index>(s.data.size());
  Matrix R(runs * n, n), D = s.D;
  for (Index r = 0; r < runs; ++r)
    R.middleRows(r * n, n) = s.data[static_cast<std::size_t>(r)].root() / std::sqrt(Real(runs));
  const bool known = problem.known.size() > 0;
  if (known || D.rows() == n * nx) {
    R = expanded(R, nx);
    if (D.rows() == n) D = expanded(D, nx);
  }
  std::vector<Index> free;
  for (Index e = 0; e < R.cols(); ++e)
    if (!known || std::isnan(problem.known(e % nx, e / nx))) free.push_back(e);
  const Matrix part = R(Eigen::all, free), asked = D(free, free);
  // Columns of one length first: states have units, rounding has none.
  const Vector scale = part.colwise().norm();
  if (!(scale.minCoeff() > 0.0L)) return 0.0L;
  const Matrix inverse = scale.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Matrix> qr(part * inverse);
  const Matrix U = qr.matrixQR().topRows(part.cols()).triangularView<Eigen::Upper>();
  if (!(U.diagonal().cwiseAbs().minCoeff() > 1e-17L)) return 0.0L;
  const auto lower = U.transpose().triangularView<Eigen::Lower>();
  const Matrix half = lower.solve(Matrix(inverse * asked * inverse));
  const Matrix ratio = lower.solve(Matrix(half.transpose()));
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(0.5L * (ratio + ratio.transpose()));
  return 1.0L / (problem.gamma_w * eigen.eigenvalues().maxCoeff());
}

/// The least value of [a; 1]ᵀ (cost + t R) [a; 1] + t c over a, for the best t >= 0.
Real bestLeastValue(const Matrix& cost, const Matrix& R, Real c) {
  const Index p = cost.rows() - 1;
  // Coordinates in which cost is the identity and R diagonal.
  const Eigen::LLT<Matrix> llt(cost.topLeftCorner(p, p));
  if (llt.info() != Eigen::Success) return 0.0L;
  const Matrix half = llt.matrixL().solve(R.topLeftCorner(p, p));
  const Matrix normal = llt.matrixL().solve(half.transpose());
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(0.5L * (normal + normal.transpose()));
  const Vector lambda = eigen.eigenvalues();
  const auto turned = [&](const Matrix& m) {
    return Vector(eigen.eigenvectors().transpose() *
                  llt.matrixL().solve(Matrix(m.topRightCorner(p, 1))).col(0));
  };
  const Vector g0 = turned(cost), g1 = turned(R);
  const auto value = [&](Real t) {
    Real sum = cost(p, p) + t * (R(p, p) + c);
    for (Index i = 0; i < p; ++i) {
      const Real g = g0(i) + t * g1(i), curvature = 1.0L + t * lambda(i);
      if (g != 0.0L) sum -= g * g / curvature;
    }
    return sum;
  };
  if (!(lambda.minCoeff() < 0.0L)) return value(0.0L);
  const Real limit = -1.0L / lambda.minCoeff();  // up to here the form is convex
  if (g0.isZero(0.0L) && g1.isZero(0.0L)) return std::max(value(0.0L), value(limit));
  Real low = 0.0L, high = limit * (1.0L - 1e-15L);
  for (int i = 0; i < 300; ++i) {  // ternary search: value(t) is concave
    const Real a = low + (high - low) / 3.0L, b = high - (high - low) / 3.0L;
    (value(a) < value(b) ? low : high) = value(a) < value(b) ? a : b;
  }
  return value(0.5L * (low + high));
}

/// What the multipliers prove about γ_e.
Real provedBound(const Sums& s, const Matrix& Y) {
  const Matrix D = Y.rows() == s.D.rows() ? s.D : expanded(s.D, s.problem.numStates());
  if (Y.rows() != D.rows()) return 0.0L;
  const Matrix R = s.peaks - 2.0L * s.weight;
  const Real reward = Y.cwiseProduct(D * Y).sum();
  const Real constant = 2.0L * s.problem.gamma_w * reward - s.peak_limits;
  const Real square = bestLeastValue(s.cost, R, constant);
  return square > 0.0L && std::isfinite(square) ? std::sqrt(square) : 0.0L;
}

void checkMultiplierShapes(const ExplorationProblem& problem, const DesignClaims& claims) {
  const Index n = problem.numRegressors(), all = n * problem.numStates();
  const auto fits = [&](const Eigen::MatrixXd& m, const char* name, bool square) {
    const bool right = m.rows() == n || m.rows() == all;
    require(m.size() == 0 || (right && (!square || m.cols() == m.rows())),
            "{} is {} x {}; must have {} rows (D (x) I) or {}{}", name, m.rows(), m.cols(), n, all,
            square ? ", and as many columns" : "");
  };
  fits(claims.multiplier, "multiplier", true);
  fits(claims.multiplier_root, "multiplier_root", false);
  const Index size = problem.D_des.rows() == all ? all : n;  // known entries make it another
  require(claims.certificate.size() == 0 || problem.known.size() > 0 ||
              (claims.certificate.rows() == size && claims.certificate.cols() == size),
          "certificate is {} x {}; must be {} x {}", claims.certificate.rows(),
          claims.certificate.cols(), size, size);
}

void checkShapes(const ExplorationProblem& problem, const DesignClaims& claims) {
  const int carriers = problem.numAmplitudes() / problem.numInputs();
  const Index rows = claims.amplitudes.rows();
  require(
      rows >= carriers && rows % carriers == 0 && claims.amplitudes.cols() == problem.numInputs(),
      "amplitudes are {} x {}; must be {} carriers (times the number of experiments) x {} "
      "inputs",
      rows, claims.amplitudes.cols(), carriers, problem.numInputs());
  requireFinite(claims.amplitudes, "amplitudes");
  requireFinite(claims.certificate, "certificate");
  requireFinite(claims.multiplier, "multiplier");
  requireFinite(claims.multiplier_root, "multiplier_root");
  checkMultiplierShapes(problem, claims);
  for (const DesignClaims::Peak& peak : claims.peak_multipliers) {
    require(problem.u_max.size() > 0, "there are peak multipliers, but the problem has no u_max");
    require(peak.sample >= 0 && peak.sample < problem.lines.num_samples && peak.input >= -1 &&
                peak.input < problem.numInputs() &&
                (problem.u_max.size() == 1 || peak.input >= 0) && std::isfinite(peak.value),
            "peak multiplier of sample {}, input {}, value {} does not fit the problem",
            peak.sample, peak.input, peak.value);
  }
}

/// Root of the multiplier in raw coordinates; zero if there is none.
Matrix multiplierRoot(const ExplorationProblem& problem, const DesignClaims& claims) {
  const Index n = problem.numRegressors(), nx = problem.numStates();
  if (claims.multiplier_root.size() > 0) return claims.multiplier_root.cast<Real>();
  Matrix M = claims.multiplier.cast<Real>();
  const Matrix D = meaning(problem);
  if (M.size() == 0 && claims.certificate.rows() == D.rows() &&
      claims.certificate.rows() == claims.certificate.cols())
    M = rawMultiplier(claims.certificate.cast<Real>(), D);
  const bool square = M.rows() == M.cols() && (M.rows() == n || M.rows() == n * nx);
  if (!square || !M.allFinite()) return Matrix::Zero(n, 1);
  return positiveRoot(M);
}

bool close(Real a, Real b, Real tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

/// The same up to a positive factor: bounds do not depend on it.
bool sameUpToScale(const Matrix& a, const Matrix& b) {
  const Real na = a.norm(), nb = b.norm();
  if (na == 0.0L || nb == 0.0L) return na == nb;
  return (a / na - b / nb).norm() <= AuditTolerance::kSaidTwice;
}

/// Far from singular: where D_des is not, the certificate's coordinates are the design's own, and
/// D^{-1/2} in doubles has not the digits that two roundings of one matrix are compared to.
bool isDefinite(const Matrix& D) {
  const Vector lambda = Eigen::SelfAdjointEigenSolver<Matrix>(D).eigenvalues();
  return lambda(0) > 1e-10L * lambda(lambda.size() - 1);
}

/// What is said beside the amplitudes and the bound: nothing of it is used, but a reader may.
void checkTheRest(const ExplorationProblem& problem, const DesignClaims& claims, const Matrix& Y,
                  int runs, AuditReport& report) {
  const auto add = [&](const char* name, bool passed, const std::string& finding) {
    report.checks.push_back({name, passed, finding});
  };
  add("experiments", runs == problem.experiments,
      fmt::format("the design has amplitudes for {} of them; the problem asks for {}", runs,
                  problem.experiments));
  if (claims.lambda_min) {
    add("lambda_min", close(report.lambda_min, *claims.lambda_min, AuditTolerance::kSaidTwice),
        fmt::format("{:.12g} of gamma_w D_des from the amplitudes; claimed {:.12g}",
                    report.lambda_min, *claims.lambda_min));
  }
  if (!claims.status.empty()) {
    const bool answered = claims.status == "solved" || claims.status == "reduced_accuracy" ||
                          claims.status == "iteration_limit";
    add("status", answered,
        fmt::format("'{}'; solved, reduced_accuracy or iteration_limit come with amplitudes",
                    claims.status));
  }
  if (claims.multiplier_root.size() == 0 && claims.multiplier.size() == 0) return;
  const Matrix M = Y * Y.transpose(), D = meaning(problem);
  if (claims.multiplier.size() > 0) {
    const Matrix claimed = claims.multiplier.cast<Real>();
    add("multiplier",
        claimed.rows() == M.rows() && claimed.cols() == M.cols() && sameUpToScale(claimed, M),
        "the multiplier must be Y Y^T of multiplier_root, or at least positive semidefinite");
  }
  const bool comparable = problem.known.size() == 0 && claims.certificate.rows() == D.rows() &&
                          D.rows() == M.rows() && isDefinite(D);
  if (comparable) {
    const Matrix root = Eigen::SelfAdjointEigenSolver<Matrix>(D).operatorSqrt();
    const Matrix claimed = claims.certificate.cast<Real>();
    add("certificate", claimed.cols() == M.cols() && sameUpToScale(claimed, root * M * root),
        "the certificate must be D^{1/2} M D^{1/2} of the multiplier M");
  }
}

}  // namespace

bool AuditReport::passed() const {
  return std::all_of(checks.begin(), checks.end(), [](const AuditCheck& c) { return c.passed; });
}

AuditReport audit(const ExplorationProblem& problem, const DesignClaims& claims) {
  validate(problem);
  checkShapes(problem, claims);
  const Matrix Y = multiplierRoot(problem, claims);
  Sums s = simulate(problem, Y, claims);
  const auto runs = static_cast<Real>(s.data.size());
  const bool on_input = problem.cost == CostOn::kInput;
  Real square = claims.amplitudes.cast<Real>().squaredNorm() / runs;
  if (on_input) {
    square = 0.0L;
    for (const Real energy : s.energy) square += 2.0L * energy / problem.lines.num_samples / runs;
    s.cost *= 2.0L / problem.lines.num_samples;
  } else {
    s.cost.setIdentity();
    s.cost(s.p, s.p) = 0.0L;
  }
  AuditReport report;
  report.lambda_min = static_cast<double>(feasibility(s));
  report.gamma_e = static_cast<double>(std::sqrt(square));
  report.lower_bound = static_cast<double>(provedBound(s, Y));
  report.gap = (report.gamma_e - report.lower_bound) / report.gamma_e;
  report.peak = static_cast<double>(s.largest_inputs(problem.numInputs()));
  const auto add = [&](const char* name, bool passed, const std::string& finding) {
    report.checks.push_back({name, passed, finding});
  };
  add("feasible", report.lambda_min >= 1.0 - AuditTolerance::kInformation,
      fmt::format("the simulated information is {:.12g} of gamma_w D_des; must be 1 or above",
                  report.lambda_min));
  add("cost", close(report.gamma_e, claims.gamma_e, AuditTolerance::kCost),
      fmt::format("gamma_e = {:.12g} from the amplitudes; claimed {:.12g}", report.gamma_e,
                  claims.gamma_e));
  add("lower_bound", claims.lower_bound <= report.lower_bound * (1.0 + AuditTolerance::kBound),
      fmt::format("the multiplier proves gamma_e >= {:.12g}; claimed {:.12g}", report.lower_bound,
                  claims.lower_bound));
  const double claimed_gap = (claims.gamma_e - claims.lower_bound) / claims.gamma_e;
  add("gap",
      std::abs(claims.gap - claimed_gap) <= AuditTolerance::kGap &&
          claimed_gap >= -AuditTolerance::kGap,
      fmt::format("(gamma_e - lower_bound)/gamma_e = {:.6g} of the claims; claimed {:.6g}",
                  claimed_gap, claims.gap));
  for (Index j = 0; j < problem.u_max.size(); ++j) {
    const bool norm = problem.u_max.size() == 1;
    const auto peak = static_cast<double>(s.largest_inputs(norm ? problem.numInputs() : j));
    report.peak_ratio = std::max(report.peak_ratio, peak / problem.u_max(j));
    add("peak", peak <= problem.u_max(j) * (1.0 + AuditTolerance::kPeak),
        fmt::format("the largest {} is {:.9g}; u_max = {:.9g}",
                    norm ? std::string("||u_k||") : fmt::format("|u_{}|", j + 1), peak,
                    problem.u_max(j)));
  }
  checkTheRest(problem, claims, Y, static_cast<int>(s.data.size()), report);
  return report;
}

}  // namespace explore_opt
