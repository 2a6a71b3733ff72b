/// The relaxations against an independent solver (CSDP) and against the published matrix
/// inequality, of which ours is the Schur complement.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unsupported/Eigen/KroneckerProduct>

#include "barrier_program.hpp"
#include "design_tools.hpp"
#include "inner_relaxation.hpp"
#include "relaxation.hpp"
#include "sdpa.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::smallestEigenvalue;
using explore_opt::testing::thesisProblem;

namespace {

std::vector<ExplorationProblem> problems() {
  ExplorationProblem two = thesisProblem(Phase::kBoth, 100);
  two.A = (MatrixXd(2, 2) << 0.8, 0.2, -0.1, 0.7).finished();
  two.B = (MatrixXd(2, 2) << 1.0, 0.3, -0.4, 0.8).finished();
  ExplorationProblem full = thesisProblem(Phase::kCos);
  const MatrixXd m = randomMatrix(3, 0, 6, 6);
  full.D_des = 20.0 * (m * m.transpose() + MatrixXd::Identity(6, 6));
  return {thesisProblem(Phase::kSin), thesisProblem(Phase::kCos), two, full};
}

struct Scaled {
  explicit Scaled(const ExplorationProblem& problem, std::uint64_t seed)
      : task(taskOf(problem)),
        reference(task.onBoundary(randomDirection(task, seed, 0))),
        program(task.response, task.gamma_w, reference) {}
  DesignTask task;
  VectorXd reference;
  QuadraticProgram program;
};

bool hasCsdp() { return std::system("command -v csdp >/dev/null 2>&1") == 0; }

/// y of CSDP's answer; empty if it has none.
VectorXd solveWithCsdp(const LmiProgram& program) {
  namespace fs = std::filesystem;
  const fs::path dir =
      fs::temp_directory_path() / ("explore_opt_csdp_" + std::to_string(::getpid()));
  fs::create_directories(dir);
  explore_opt::testing::writeSdpa(program, (dir / "p.dat-s").string());
  const std::string run = "cd '" + dir.string() + "' && csdp p.dat-s answer >/dev/null 2>&1";
  VectorXd y;
  if (std::system(run.c_str()) == 0) {
    std::ifstream in(dir / "answer");
    y.resize(program.reward.size());
    for (double& value : y) in >> value;
    if (!in) y.resize(0);
  }
  fs::remove_all(dir);
  return y;
}

/// min γ s.t. S(a) ⪰ 0 and [γ I, a; aᵀ, γ] ⪰ 0: the paper's energy inequality. Variables a, γ.
LmiProgram innerAsLmi(const BarrierProgram& barrier, int p) {
  LmiProgram lmi;
  lmi.reward = -VectorXd::Unit(p + 1, p);
  LmiBlock slack{barrier.slack(VectorXd::Zero(p)), 0, p, {}}, energy;
  energy.constant = MatrixXd::Zero(p + 1, p + 1);
  energy.count = p + 1;
  for (int i = 0; i < p; ++i) {
    slack.slopes.push_back(barrier.slack(VectorXd::Unit(p, i)) - slack.constant);
    MatrixXd arrow = MatrixXd::Zero(p + 1, p + 1);
    arrow(i, p) = arrow(p, i) = 1.0;
    energy.slopes.push_back(arrow);
  }
  energy.slopes.push_back(MatrixXd::Identity(p + 1, p + 1));
  lmi.blocks = {slack, energy};
  return lmi;
}

}  // namespace

TEST(Csdp, InnerRelaxationsAgree) {
  if (!hasCsdp()) GTEST_SKIP() << "csdp is not installed (Debian package coinor-csdp)";
  IpoptSolver solver(1e-9, 200);
  std::uint64_t seed = 0;
  for (const ExplorationProblem& problem : problems()) {
    for (int repeat = 0; repeat < 3; ++repeat) {
      SCOPED_TRACE(++seed);
      const Scaled s(problem, seed);
      const VectorXd candidate = s.program.toScaled(s.reference);
      const InnerSolution ours = solveInnerRelaxation(s.program, solver, candidate, 1e-10);
      ASSERT_TRUE(ours.centred);
      const BarrierProgram barrier(s.program, candidate);
      const VectorXd y = solveWithCsdp(innerAsLmi(barrier, s.program.numAmplitudes()));
      ASSERT_GT(y.size(), 0);
      // CSDP stops at a relative gap of 1e-8; our barrier at n μ = 1e-10 of a value near 1/2.
      EXPECT_NEAR(ours.a.norm(), y(y.size() - 1), 1e-7 * ours.a.norm());
    }
  }
}

TEST(Csdp, LowerBoundsAgree) {
  if (!hasCsdp()) GTEST_SKIP() << "csdp is not installed (Debian package coinor-csdp)";
  std::uint64_t seed = 100;
  for (const ExplorationProblem& problem : problems()) {
    SCOPED_TRACE(++seed);
    const Scaled s(problem, seed);
    const int n = s.program.size(), p = s.program.numAmplitudes();
    const bool lift = p * (p + 1) < n * (n + 1);  // as the design chooses
    const LmiProgram lmi = lift ? liftedProgram(s.program) : dualProgram(s.program);
    const VectorXd start =
        lift ? liftedStart(s.program, s.program.toScaled(s.reference)) : dualStart(s.program);
    const LmiSolution ours = solveLmi(lmi, start, 1e-9);
    const VectorXd y = solveWithCsdp(lmi);
    ASSERT_EQ(y.size(), ours.y.size());
    EXPECT_NEAR(lmi.reward.dot(ours.y), lmi.reward.dot(y), 1e-7 * std::abs(lmi.reward.dot(y)));
  }
}

namespace {

/// The published inequality at amplitudes a, linearised at ã: regressors Φ and data X̂ of the
/// prediction, math.md 2.1. Size n_φ n_x + (n_φ n_x)².
class PublishedInequality {
 public:
  explicit PublishedInequality(const ExplorationProblem& problem)
      : problem_(problem),
        nx_(problem.numStates()),
        N_(problem.numRegressors() * nx_),
        Theta_(nx_, problem.numRegressors()) {
    Theta_ << problem.A, problem.B;
    for (int i = 0; i < problem.numAmplitudes(); ++i)
      responses_.push_back(unitResponse(problem, i));
  }

  MatrixXd phi(const VectorXd& a) const {
    MatrixXd sum = MatrixXd::Zero(responses_[0].rows(), responses_[0].cols());
    for (Index i = 0; i < a.size(); ++i) sum += a(i) * responses_[std::size_t(i)];
    return sum;
  }

  MatrixXd at(const VectorXd& a, const VectorXd& candidate) const {
    const MatrixXd F = phi(a), L1 = phi(candidate), Y = tall(a), L2 = tall(candidate);
    const MatrixXd S = F * L1.transpose() + L1 * F.transpose() - L1 * L1.transpose();
    MatrixXd out = Y * L2.transpose() + L2 * Y.transpose() - L2 * L2.transpose();
    out.topLeftCorner(N_, N_) +=
        Eigen::kroneckerProduct(S, MatrixXd::Identity(nx_, nx_)).eval() -
        problem_.gamma_w * problem_.D_des(0, 0) * MatrixXd::Identity(N_, N_);
    return out;
  }

  /// The same after the Schur complement, as it is solved: Φ L1ᵀ + L1 Φᵀ - L1 L1ᵀ ⪰ γ_w D.
  MatrixXd reduced(const VectorXd& a, const VectorXd& candidate) const {
    const MatrixXd F = phi(a), L = phi(candidate);
    const Index n = F.rows();
    return F * L.transpose() + L * F.transpose() - L * L.transpose() -
           problem_.gamma_w * problem_.D_des(0, 0) * MatrixXd::Identity(n, n);
  }

 private:
  /// [D^{1/2}(X̂ᵀ ⊗ I); Φ ⊗ I ⊗ I]
  MatrixXd tall(const VectorXd& a) const {
    const MatrixXd F = phi(a), X = Theta_ * F;
    const MatrixXd identity = MatrixXd::Identity(N_, N_);
    const MatrixXd row = X.reshaped().transpose();
    const MatrixXd wide = Eigen::kroneckerProduct(F, MatrixXd::Identity(nx_, nx_));
    const MatrixXd top = Eigen::kroneckerProduct(row, identity),
                   bottom = Eigen::kroneckerProduct(wide, identity);
    MatrixXd Y(top.rows() + bottom.rows(), top.cols());
    Y << std::sqrt(problem_.D_des(0, 0)) * top, bottom;
    return Y;
  }

  const ExplorationProblem& problem_;
  int nx_, N_;
  MatrixXd Theta_;
  std::vector<MatrixXd> responses_;
};

}  // namespace

TEST(PublishedInequality, IsFeasibleExactlyWhereOursIs) {
  ExplorationProblem problem;
  problem.A = (MatrixXd(2, 2) << 0.9, 0.3, -0.2, 0.6).finished();
  problem.B = (MatrixXd(2, 1) << 0.2, 1.0).finished();
  problem.lines = {14, {1, 3, 5}, {}};
  problem.gamma_w = 0.7;
  problem.D_des = MatrixXd::Constant(1, 1, 3.0);
  const PublishedInequality published(problem);
  const DesignTask task = taskOf(problem);
  int feasible = 0, infeasible = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const VectorXd candidate = task.onBoundary(randomDirection(task, 11, i));
    const VectorXd direction = randomDirection(task, 12, i);
    const double size = 0.3 + 0.05 * static_cast<double>(i);
    const VectorXd a = size * candidate + 0.1 * direction;
    const double ours = smallestEigenvalue(published.reduced(a, candidate));
    if (std::abs(ours) < 1e-3) continue;  // too close to the boundary to call
    const double theirs = smallestEigenvalue(published.at(a, candidate));
    // On the boundary of a semidefinite block, 1e-16 times its norm of about 1e3 is rounding.
    EXPECT_EQ(ours > 0.0, theirs > -1e-10) << ours << " " << theirs;
    ++(ours > 0.0 ? feasible : infeasible);
  }
  EXPECT_GT(feasible, 5);
  EXPECT_GT(infeasible, 5);
}
