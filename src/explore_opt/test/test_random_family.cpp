/// A family of 240 seeded random problems: every answer judged from the raw data. ctest runs a
/// thirteenth of it; EXPLORE_OPT_FAMILY=docs/random_family.md runs all, with 50 further starts
/// where n_u >= 2, and writes the table.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <string>

#include "explore_opt/exploration_design.hpp"
#include "local_search.hpp"
#include "quad_support/linear_algebra.hpp"
#include "quad_support/random_stream.hpp"
#include "raw_audit.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::rawBound;
using explore_opt::testing::rawLambdaMin;
using quad_support::spectralRadius;

namespace {

constexpr int kProblems = 240;
constexpr int kStride = 13;  // ctest runs every thirteenth: all kinds and sizes in turn
const char* const kKinds[] = {"stable", "marginal", "unstable", "unstable, K", "full D"};

struct Member {
  ExplorationProblem problem;
  std::string kind;
  bool settled = false;  ///< transients have died out long before the end
};

class Dice {
 public:
  explicit Dice(int index) : random_(static_cast<std::uint64_t>(index), 7, 0) {}
  double uniform() { return random_.uniform(next_++, 0); }
  double between(double a, double b) { return a + (b - a) * uniform(); }
  int whole(int a, int b) { return std::min(b, a + static_cast<int>(uniform() * (b - a + 1))); }

 private:
  quad_support::RandomStream random_;
  std::uint64_t next_ = 0;
};

/// A stable matrix beside, for odd sizes, an integrator, else a rotation or a double integrator.
MatrixXd marginal(const MatrixXd& stable, Dice& dice) {
  MatrixXd A = stable;
  const Eigen::Index n = A.rows();
  if (n == 1) return MatrixXd::Ones(1, 1);
  A.bottomRows(2).setZero();
  A.rightCols(2) *= 0.3;
  const double angle = dice.between(0.3, 2.5);
  if (dice.uniform() < 0.5) {
    A.bottomRightCorner(2, 2) << 1.0, 0.2, 0.0, 1.0;
  } else {
    A.bottomRightCorner(2, 2) << std::cos(angle), -std::sin(angle), std::sin(angle),
        std::cos(angle);
  }
  return A;
}

MatrixXd spd(int index, std::uint64_t stream, int n) {
  const MatrixXd m = randomMatrix(static_cast<std::uint64_t>(index), stream, n, n);
  MatrixXd D = m * m.transpose() / n + 0.3 * MatrixXd::Identity(n, n);
  return 0.5 * (D + D.transpose());
}

/// Feedback of 500 steps of the Riccati recursion in its plain form. As a rule A + B K is stable,
/// but not for every problem (178 and 218): those stay in, to be refused.
MatrixXd riccatiFeedback(const MatrixXd& A, const MatrixXd& B) {
  const auto n = A.rows(), m = B.cols();
  MatrixXd P = MatrixXd::Identity(n, n), K(m, n);
  for (int i = 0; i < 500; ++i) {
    K = -(MatrixXd::Identity(m, m) + B.transpose() * P * B).ldlt().solve(B.transpose() * P * A);
    P = MatrixXd::Identity(n, n) + A.transpose() * P * (A + B * K);
  }
  return K;
}

void chooseLines(Dice& dice, ExplorationProblem& problem, int L) {
  const int T = problem.lines.num_samples, most = (T - 1) / 2;
  std::vector<int> harmonics;
  while (static_cast<int>(harmonics.size()) < L) {
    const int h = dice.whole(1, most);
    if (std::find(harmonics.begin(), harmonics.end(), h) == harmonics.end()) harmonics.push_back(h);
  }
  std::sort(harmonics.begin(), harmonics.end());
  if (dice.uniform() < 0.75) {
    problem.lines.harmonics = harmonics;
    return;
  }
  for (const int h : harmonics)  // off the grid
    problem.lines.frequencies.push_back((h + dice.between(-0.3, 0.3)) / T);
}

/// n_x 1-8, n_u 1-3, L 2-16, T 20-5000 (log-uniform), five kinds.
Member member(int index) {
  Dice dice(index);
  const int kind = index % 5, nu = 1 + (index / 5) % 3;
  int nx = 1 + (index / 15) % 8;
  if (kind == 4) nx = 1 + (nx - 1) % 4;  // a full D of size n_x n_φ <= 28
  Member m;
  m.kind = kKinds[kind];
  ExplorationProblem& problem = m.problem;
  const int fewest = std::max({2, nu, (nx + nu + 1) / 2});
  const int L = dice.whole(fewest, 16);
  const int shortest = std::max({20, 2 * L + 3, 3 * (nx + nu)});
  problem.lines.num_samples =
      static_cast<int>(shortest * std::pow(5000.0 / shortest, dice.uniform()));
  const int T = problem.lines.num_samples;
  const auto seed = static_cast<std::uint64_t>(index);
  const MatrixXd raw = randomMatrix(seed, 0, nx, nx);
  const double radius = dice.between(0.3, 0.95);
  const MatrixXd stable = raw * (radius / spectralRadius(raw));
  problem.A = stable;
  if (kind == 1) problem.A = marginal(stable, dice);
  if (kind == 2)
    problem.A = raw * (std::pow(dice.between(3.0, 3e3), 1.0 / T) / spectralRadius(raw));
  if (kind == 3) problem.A = raw * (dice.between(1.02, 1.6) / spectralRadius(raw));
  problem.B = randomMatrix(seed, 1, nx, nu);
  if (kind == 3) problem.K = riccatiFeedback(problem.A, problem.B);
  problem.phase = std::array{Phase::kCos, Phase::kSin, Phase::kBoth}[std::size_t(dice.whole(0, 2))];
  chooseLines(dice, problem, L);
  problem.gamma_w = dice.between(0.5, 20.0);
  const double closeness = dice.between(1.0, 100.0);
  if (kind == 4) {
    problem.D_des = closeness * spd(index, 2, nx * (nx + nu));
  } else if (dice.uniform() < 0.3) {
    problem.D_des = closeness * spd(index, 2, nx + nu);
  } else {
    problem.D_des = MatrixXd::Constant(1, 1, closeness);
  }
  m.settled = (kind == 0 || kind == 4) && T * (1.0 - radius) > 50.0;
  return m;
}

struct Judgement {
  DesignResult result;
  double lambda_min = 0.0, bound_error = 0.0, best = std::numeric_limits<double>::quiet_NaN();
};

/// The cheapest of local solutions from 50 random starts, apart from the solver's own: each to
/// 1e-4, the best three to full accuracy.
double bestOfFifty(const ExplorationProblem& problem) {
  const DesignTask task = taskOf(problem);
  IpoptSolver solver(1e-9, 150);
  std::multimap<double, VectorXd> found;
  for (std::uint64_t i = 0; i < 50; ++i) {
    const VectorXd direction = randomDirection(task, 4711, i);
    if (!std::isfinite(task.cost(direction))) continue;
    const VectorXd end = glimpse(task, task.onBoundary(direction));
    if (end.size() > 0) found.emplace(end.norm(), end);
  }
  double best = std::numeric_limits<double>::infinity();
  int polished = 0;
  for (const auto& [norm, end] : found) {
    if (++polished > 3) break;
    const LocalSolution local = polish(task, solver, end, 1e-2, nullptr);
    best = std::min(best, local.amplitudes.size() > 0 ? local.amplitudes.norm() : norm);
  }
  return best;
}

Judgement judge(const Member& m, bool fifty) {
  Judgement j;
  j.result = designExploration(m.problem);
  if (!j.result.feasible()) return j;
  j.lambda_min = rawLambdaMin(m.problem, j.result.amplitudes);
  if (m.problem.lines.num_samples * m.problem.numAmplitudes() <=
      40000)  // long double takes its time
    j.bound_error = 1.0 - rawBound(m.problem, j.result) / j.result.lower_bound;
  if (fifty && m.problem.numInputs() >= 2) j.best = bestOfFifty(m.problem);
  return j;
}

/// The acceptance; a problem without an answer passes with a negative status and a reason.
void expectGood(const Member& m, const Judgement& j) {
  const DesignResult& r = j.result;
  if (!r.feasible()) {
    EXPECT_TRUE(r.status == DesignStatus::kNotExciting ||
                r.status == DesignStatus::kNumericalError || r.status == DesignStatus::kInfeasible);
    EXPECT_FALSE(r.message.empty());
    return;
  }
  EXPECT_GE(j.lambda_min, 1.0 - 1e-9);
  EXPECT_GE(r.gamma_e, r.lower_bound);
  EXPECT_LE(std::abs(j.bound_error), 1e-6);
  if (m.problem.numInputs() == 1) {
    EXPECT_LE(r.gap, m.settled ? 1e-3 : 1e-2) << r.message;
  }
  if (!std::isnan(j.best)) {
    EXPECT_LE(r.gamma_e, 1.005 * j.best);
    EXPECT_LE(r.lower_bound, j.best * (1.0 + 1e-9));
  }
}

std::string row(int index, const Member& m, const Judgement& j) {
  const ExplorationProblem& p = m.problem;
  std::string text = fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |", index, m.kind,
                                 p.numStates(), p.numInputs(), p.lines.size(), p.lines.num_samples,
                                 toString(p.phase), p.lines.harmonics.empty() ? "off" : "on");
  const DesignResult& r = j.result;
  if (!r.feasible())
    return text +
           fmt::format(" {} | – | – | – | – | {:.0f} |\n", toString(r.status), 1e3 * r.seconds);
  return text + fmt::format(" {} | {:.6g} | {:.1e} | {:.0e} | {} | {:.0f} |\n", toString(r.status),
                            r.gamma_e, r.gap, j.lambda_min - 1.0,
                            std::isnan(j.best) ? "–" : fmt::format("{:.4f}", r.gamma_e / j.best),
                            1e3 * r.seconds);
}

struct Group {
  int count = 0, feasible = 0, tight = 0;
  double worst_gap = 0.0, worst_ratio = 0.0;
  std::vector<double> milliseconds;
};

void publish(const std::string& path, const std::map<std::string, Group>& groups,
             const std::map<int, std::string>& rows, const std::map<int, std::string>& negatives) {
  std::ofstream out(path);
  out << fmt::format("# {} of {} random problems\n\n", rows.size(), kProblems)
      << "Seeded; n_x 1 to 8, n_u 1 to 3, L 2 to 16 lines, T 20 to 5000, cos, sin or both phases, "
         "three "
         "quarters of them on the grid. `unstable` grows up to\n3000-fold in open loop, `unstable, "
         "K` "
         "has poles up to 1.6 and the feedback of 500 plain steps of the Riccati recursion, which "
         "does not\nstabilise every one (178 and 218, below). `full D` has a random D_des of size "
         "n_x n_φ. "
         "Remade by\n\n"
         "```\nEXPLORE_OPT_FAMILY=docs/random_family.md "
         "build/devel/lib/explore_opt/test_random_family\n```\n\n"
         "Every answer is simulated anew in long double: λ_min is that of the raw data over γ_w, "
         "less 1 "
         "(accepted from −1e-9). `cost/best` compares with the best of 50\nother random starts of "
         "the "
         "local solver, for n_u ≥ 2 (accepted up to 1.005). Gaps are certified; for n_u = 1 up to "
         "1e-2 "
         "is accepted, 1e-3 where transients\nare negligible. A gap for n_u ≥ 2 is that of the "
         "relaxation: one phase for several inputs leaves it open.\n\n"
         "| kind, n_u | problems | answered | gap ≤ 1e-5 | largest gap | largest cost/best | "
         "median ms "
         "| slowest ms |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (auto [name, g] : groups) {
    std::sort(g.milliseconds.begin(), g.milliseconds.end());
    out << fmt::format("| {} | {} | {} | {} | {:.1e} | {} | {:.0f} | {:.0f} |\n", name, g.count,
                       g.feasible, g.tight, g.worst_gap,
                       g.worst_ratio > 0.0 ? fmt::format("{:.4f}", g.worst_ratio) : "–",
                       g.milliseconds[g.milliseconds.size() / 2], g.milliseconds.back());
  }
  if (!negatives.empty()) out << "\nWithout an answer:\n\n";
  for (const auto& [index, text] : negatives) out << text;
  out << "\n| # | kind | n_x | n_u | L | T | phase | grid | status | γ_e | gap | λ_min | cost/best "
         "| "
         "ms |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | "
         "--- |\n";
  for (const auto& [index, text] : rows) out << text;
}

}  // namespace

/// EXPLORE_OPT_FAMILY_PROBLEM=239: that one alone, told on stdout.
TEST(RandomFamily, OneProblem) {
  const char* number = std::getenv("EXPLORE_OPT_FAMILY_PROBLEM");
  if (number == nullptr) GTEST_SKIP() << "EXPLORE_OPT_FAMILY_PROBLEM names none";
  const int index = std::atoi(number);
  const Member m = member(index);
  const Judgement j = judge(m, false);
  expectGood(m, j);
  fmt::print("{}{}\n", row(index, m, j), j.result.message);
}

TEST(RandomFamily, EveryAnswerHolds) {
  const char* path = std::getenv("EXPLORE_OPT_FAMILY");
  std::map<std::string, Group> groups;
  std::map<int, std::string> rows, negatives;
  const int count = path != nullptr ? kProblems : (kProblems + kStride - 1) / kStride;
  for (int i = 0; i < count; ++i) {
    const int index = i * kStride % kProblems;  // kinds and sizes in turn, each problem once
    SCOPED_TRACE(index);
    const Member m = member(index);
    const Judgement j = judge(m, path != nullptr);
    expectGood(m, j);
    Group& g = groups[fmt::format("{}, {}", m.kind, m.problem.numInputs())];
    ++g.count;
    g.milliseconds.push_back(1e3 * j.result.seconds);
    rows[index] = row(index, m, j);
    if (j.result.feasible()) {
      ++g.feasible;
      if (j.result.gap <= 1e-5) ++g.tight;
      g.worst_gap = std::max(g.worst_gap, j.result.gap);
      if (!std::isnan(j.best)) g.worst_ratio = std::max(g.worst_ratio, j.result.gamma_e / j.best);
    } else {
      negatives[index] = fmt::format("* {}: {}\n", index, j.result.message);
    }
    if (path != nullptr) publish(path, groups, rows, negatives);  // what there is, if interrupted
  }
}
