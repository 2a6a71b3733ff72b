#include "response_root.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "constants.hpp"

namespace explore_opt {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLargest = 1e100;  // its fourth power overflows
/// Of unstable modes within T. Optimal amplitudes cancel them and live on what remains: 1e-16 of
/// the growth is rounding, and three digits are needed (test_growth).
constexpr double kMostGrowth = 1e13;
constexpr double kNoise = 1e-16;  // of a column's length: rounding of the triangle itself

/// Triangle with the same products of columns. Columns are scaled to length one and pivoted, so the
/// rows that rounding alone has left are the last ones; there are at most `most` others.
MatrixXd compressed(const MatrixXd& rows, Index most) {
  VectorXd lengths(rows.cols());
  for (Index j = 0; j < rows.cols(); ++j) {
    lengths(j) = rows.col(j).stableNorm();
    if (!(lengths(j) > 0.0)) lengths(j) = 1.0;
  }
  const MatrixXd scaled = rows * lengths.cwiseInverse().asDiagonal();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(scaled);
  const MatrixXd& packed = qr.matrixQR();
  Index rank = std::min({packed.rows(), packed.cols(), most});
  while (rank > 1 && std::abs(packed(rank - 1, rank - 1)) < kNoise) --rank;
  const MatrixXd upper = packed.topRows(rank).triangularView<Eigen::Upper>();
  return upper * qr.colsPermutation().transpose() * lengths.asDiagonal();
}

/// Rows z_0 ... z_{t-1}, or a triangle in their place, of the generator z = [states of all
/// components; state from x_0; cosine and sine of all lines], and its t-th power, block by block.
class Horizon {
 public:
  explicit Horizon(const ExplorationProblem& problem)
      : problem_(problem),
        nx_(problem.numStates()),
        p_(problem.numAmplitudes()),
        num_states_(p_ + (problem.x0.isZero(0.0) ? 0 : 1)),
        closed_(problem.dynamics()),
        power_(closed_),
        rows_(first()) {
    requireModestGrowth();
    for (int a = 0; a < p_; ++a) drive_.push_back(driveOfOne(a));
  }

  void extendTo(int T) {
    int bit = 0;
    while ((T >> (bit + 1)) > 0) ++bit;
    while (--bit >= 0) {
      twice();
      if ((T >> bit) & 1) once();
    }
    rows_ = compressed(rows_, rank());
    require();
  }

  MatrixXd states(int a) const { return rows_.middleCols(a * nx_, nx_); }
  VectorXd carrier(int a) const { return rows_.col(carrierColumn(a) + (isSine(a) ? 1 : 0)); }
  bool hasStart() const { return num_states_ > p_; }
  Index rows() const { return rows_.rows(); }

 private:
  /// Every entry of every response solves one recursion in k of this order: the characteristic
  /// polynomials of A (or A + B K) and of the lines.
  Index rank() const { return nx_ + 2 * problem_.lines.size(); }
  int line(int a) const { return (a / problem_.numInputs()) % problem_.lines.size(); }
  bool isSine(int a) const {
    return problem_.phase == Phase::kSin ||
           (problem_.phase == Phase::kBoth && a / problem_.numInputs() >= problem_.lines.size());
  }
  Index carrierColumn(int a) const { return num_states_ * nx_ + 2 * line(a); }

  MatrixXd first() const {
    MatrixXd z = MatrixXd::Zero(1, num_states_ * nx_ + 2 * problem_.lines.size());
    if (hasStart()) z.middleCols(p_ * nx_, nx_) = problem_.x0.transpose();
    for (int i = 0; i < problem_.lines.size(); ++i) z(0, num_states_ * nx_ + 2 * i) = 1.0;
    return z;
  }

  /// B_j times the row that picks the carrier from [cosine; sine].
  MatrixXd driveOfOne(int a) const {
    MatrixXd drive = MatrixXd::Zero(nx_, 2);
    drive.col(isSine(a) ? 1 : 0) = problem_.B.col(a % problem_.numInputs());
    return drive;
  }

  Matrix2d rotation(int i, int t) const {
    const CarrierValue turn = carrierAt(problem_.lines, i, t);
    return (Matrix2d() << turn.cosine, -turn.sine, turn.sine, turn.cosine).finished();
  }

  MatrixXd shifted(const MatrixXd& power, const std::vector<MatrixXd>& drive, int t) const {
    MatrixXd next(rows_.rows(), rows_.cols());
    for (int a = 0; a < num_states_; ++a) {
      next.middleCols(a * nx_, nx_) = rows_.middleCols(a * nx_, nx_) * power.transpose();
      if (a == p_) break;
      next.middleCols(a * nx_, nx_) +=
          rows_.middleCols(carrierColumn(a), 2) * drive[static_cast<std::size_t>(a)].transpose();
    }
    for (int i = 0; i < problem_.lines.size(); ++i) {
      const Index column = num_states_ * nx_ + 2 * i;
      next.middleCols(column, 2) = rows_.middleCols(column, 2) * rotation(i, t).transpose();
    }
    return next;
  }

  void twice() {
    const MatrixXd later = shifted(power_, drive_, t_);
    append(rows_, later);
    for (int a = 0; a < p_; ++a) {
      MatrixXd& drive = drive_[static_cast<std::size_t>(a)];
      drive = power_ * drive + drive * rotation(line(a), t_);
    }
    power_ = power_ * power_;
    t_ *= 2;
  }

  void once() {
    std::vector<MatrixXd> one;
    for (int a = 0; a < p_; ++a) one.push_back(driveOfOne(a));
    append(first(), shifted(closed_, one, 1));
    for (int a = 0; a < p_; ++a) {
      MatrixXd& drive = drive_[static_cast<std::size_t>(a)];
      drive = closed_ * drive + one[static_cast<std::size_t>(a)] * rotation(line(a), t_);
    }
    power_ = closed_ * power_;
    ++t_;
  }

  void append(const MatrixXd& above, const MatrixXd& below) {
    MatrixXd both(above.rows() + below.rows(), above.cols());
    both << above, below;
    rows_ = std::move(both);
    require();
    if (rows_.rows() > 2 * rank() + 8) rows_ = compressed(rows_, rank());
  }

  void requireModestGrowth() const {
    if (modeGrowth(problem_) < kMostGrowth) return;
    throw ResponseOverflow(fmt::format(
        "{} is unstable: its modes grow more than {:g}-fold within T = {}, "
        "too much for any design to be trusted. {}",
        dynamicsName(problem_), kMostGrowth, problem_.lines.num_samples, growthRemedy(problem_)));
  }

  void require() const {
    if (rows_.allFinite() && rows_.cwiseAbs().maxCoeff() < kLargest) return;
    throw ResponseOverflow(fmt::format(
        "the predicted response overflows: {} grows beyond {:g} within T = {}. {}",
        dynamicsName(problem_), kLargest, problem_.lines.num_samples, growthRemedy(problem_)));
  }

  const ExplorationProblem& problem_;
  int nx_, p_, num_states_, t_ = 1;
  MatrixXd closed_, power_;
  std::vector<MatrixXd> drive_;  ///< of [cosine; sine] at k on the state at k + t, one a component
  MatrixXd rows_;
};

}  // namespace

double modeGrowth(const ExplorationProblem& problem) {
  MatrixXd square = problem.dynamics(), half = MatrixXd::Identity(square.rows(), square.cols());
  for (int left = problem.lines.num_samples / 2; left > 0 && half.allFinite(); left /= 2) {
    if (left % 2 == 1) half = (half * square).eval();
    square = (square * square).eval();
  }
  const double before = half.norm();
  if (before == 0.0) return 0.0;  // nothing lasts so long
  const double ratio = (half * half).norm() / before;
  return std::isfinite(ratio) ? ratio * ratio : kInfinity;
}

std::string dynamicsName(const ExplorationProblem& problem) {
  return problem.K.size() > 0 ? "A + B K" : "A";
}

std::string growthRemedy(const ExplorationProblem& problem) {
  return problem.K.size() > 0 ? "Choose a K that stabilises, or shorten T"
                              : "Stabilise with K (u = K x + signal), or shorten T";
}

ResponseRoot responseRoot(const ExplorationProblem& problem) {
  Horizon horizon(problem);
  horizon.extendTo(problem.lines.num_samples);
  const int nx = problem.numStates(), nu = problem.numInputs(), p = problem.numAmplitudes();
  ResponseRoot root;
  for (int a = 0; a < p + (horizon.hasStart() ? 1 : 0); ++a) {
    MatrixXd block = MatrixXd::Zero(horizon.rows(), nx + nu);
    block.leftCols(nx) = horizon.states(a);
    if (a < p) block.col(nx + a % nu) = horizon.carrier(a);
    if (problem.K.size() > 0) block.rightCols(nu) += block.leftCols(nx) * problem.K.transpose();
    root.blocks.push_back(std::move(block));
  }
  return root;
}

double cancellation(const ExplorationProblem& problem, const MatrixXd& amplitudes) {
  const ResponseRoot root = responseRoot(problem);
  const Index p = problem.numAmplitudes(), nu = problem.numInputs(), carriers = p / nu;
  double largest = 1.0;
  for (Index run = 0; run < amplitudes.rows() / carriers; ++run) {
    MatrixXd sum = MatrixXd::Zero(root.blocks.front().rows(), problem.numRegressors());
    Eigen::RowVectorXd single = Eigen::RowVectorXd::Zero(sum.cols());
    for (Index a = 0; a < static_cast<Index>(root.blocks.size()); ++a) {
      const double factor = a < p ? amplitudes(run * carriers + a / nu, a % nu) : 1.0;
      const MatrixXd response = factor * root.blocks[static_cast<std::size_t>(a)];
      sum += response;
      single += response.colwise().norm();
    }
    const Eigen::RowVectorXd left = sum.colwise().norm();
    for (Index j = 0; j < sum.cols(); ++j)
      if (single(j) > 0.0) largest = std::max(largest, single(j) / left(j));
  }
  return largest;
}

}  // namespace explore_opt
