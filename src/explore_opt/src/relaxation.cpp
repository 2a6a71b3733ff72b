#include "relaxation.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Whether the matrices of the relaxation have a row for the constant 1 beside the amplitudes, the
/// last one.
bool hasConstant(const QuadraticProgram& program) {
  if (!program.homogeneous()) return true;
  for (const PeakConstraint& peak : program.peaks()) {
    if (!peak.offset.isZero(0.0)) return true;
  }
  return false;
}

int order(const QuadraticProgram& program) {
  return program.numAmplitudes() + (hasConstant(program) ? 1 : 0);
}

/// Q_kᵀ Q_k with the column of the constant last.
MatrixXd peakGram(const QuadraticProgram& program, const PeakConstraint& peak) {
  MatrixXd Q(peak.rows.rows(), order(program));
  Q.leftCols(program.numAmplitudes()) = peak.rows;
  if (hasConstant(program)) Q.rightCols(1) = peak.offset;
  return Q.transpose() * Q;
}

/// tr(Z S_ab), the constant last.
MatrixXd extendedH(const QuadraticProgram& program, const MatrixXd& Z) {
  const int p = program.numAmplitudes();
  MatrixXd H = MatrixXd::Zero(order(program), order(program));
  H.topLeftCorner(p, p) = program.H(Z);
  if (program.homogeneous()) return H;
  for (int a = 0; a < p; ++a) H(a, p) = H(p, a) = Z.cwiseProduct(program.S_0(a)).sum();
  H(p, p) = Z.cwiseProduct(program.S_00()).sum();
  return H;
}

/// Entry (i, j) of all S_ab, the constant last: extendedH() of a unit matrix.
MatrixXd entriesOf(const QuadraticProgram& program, int i, int j) {
  const int p = program.numAmplitudes();
  MatrixXd H = MatrixXd::Zero(order(program), order(program));
  for (int a = 0; a < p; ++a) {
    for (int b = 0; b <= a; ++b) H(a, b) = H(b, a) = program.S(a, b)(i, j);
  }
  if (program.homogeneous()) return H;
  for (int a = 0; a < p; ++a) H(a, p) = H(p, a) = program.S_0(a)(i, j);
  H(p, p) = program.S_00()(i, j);
  return H;
}

int numMultipliers(const QuadraticProgram& program) {
  return program.size() * (program.size() + 1) / 2;
}

MatrixXd unpackTriangle(const VectorXd& entries, int n) {
  MatrixXd m(n, n);
  Index next = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) m(i, j) = m(j, i) = entries(next++);
  }
  return m;
}

RelaxedSolution fromDual(const QuadraticProgram& program, const LmiSolution& solution) {
  const int p = program.numAmplitudes();
  RelaxedSolution relaxed;
  relaxed.Z = unpackTriangle(solution.y, program.size());
  relaxed.nu =
      solution.y.segment(numMultipliers(program), static_cast<Index>(program.peaks().size()));
  const MatrixXd X = 2.0 * solution.multipliers[1];
  relaxed.lifted = X.topLeftCorner(p, p);
  relaxed.mean = hasConstant(program) ? VectorXd(X.col(p).head(p)) : VectorXd(VectorXd::Zero(p));
  return relaxed;
}

RelaxedSolution fromLifted(const QuadraticProgram& program, const LmiProgram& lmi,
                           const LmiSolution& solution) {
  const int p = program.numAmplitudes();
  const MatrixXd X = lmi.blocks[0].at(solution.y);
  RelaxedSolution relaxed;
  relaxed.Z = solution.multipliers[1];
  relaxed.lifted = X.topLeftCorner(p, p);
  relaxed.mean = hasConstant(program) ? VectorXd(X.col(p).head(p)) : VectorXd(VectorXd::Zero(p));
  return relaxed;
}

}  // namespace

LmiProgram dualProgram(const QuadraticProgram& program) {
  const int n = program.size(), p = program.numAmplitudes(), m = order(program);
  const int num_Z = numMultipliers(program), num_nu = static_cast<int>(program.peaks().size());
  const int count = num_Z + num_nu + (hasConstant(program) ? 1 : 0);
  LmiProgram lmi;
  lmi.reward = VectorXd::Zero(count);
  LmiBlock slack;
  slack.constant = MatrixXd::Zero(m, m);
  slack.constant.topLeftCorner(p, p).setIdentity();
  slack.count = count;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      lmi.reward(static_cast<Index>(slack.slopes.size())) =
          (i == j ? 1.0 : 2.0) * program.rightSide()(i, j);
      slack.slopes.push_back((i == j ? -2.0 : -4.0) * entriesOf(program, i, j));
    }
  }
  for (const PeakConstraint& peak : program.peaks()) {
    lmi.reward(static_cast<Index>(slack.slopes.size())) = -0.5;
    slack.slopes.push_back(peakGram(program, peak));
  }
  if (hasConstant(program)) {
    lmi.reward(count - 1) = 1.0;
    slack.slopes.push_back(MatrixXd::Zero(m, m));
    slack.slopes.back()(p, p) = -2.0;
  }
  lmi.blocks.push_back({MatrixXd::Zero(n, n), 0, num_Z, {}});
  lmi.blocks.push_back(std::move(slack));
  for (int k = 0; k < num_nu; ++k) lmi.blocks.push_back({MatrixXd::Zero(1, 1), num_Z + k, 1, {}});
  return lmi;
}

VectorXd dualStart(const QuadraticProgram& program) {
  const int n = program.size(), p = program.numAmplitudes();
  const int num_Z = numMultipliers(program), num_nu = static_cast<int>(program.peaks().size());
  const MatrixXd identity = MatrixXd::Identity(n, n);
  const double z = 0.25 / quad_support::symmetricEigenvalues(program.H(identity))(p - 1);
  VectorXd y = VectorXd::Zero(num_Z + num_nu + (hasConstant(program) ? 1 : 0));
  for (int i = 0, k = 0; i < n; k += ++i) y(k + i) = z;
  y.segment(num_Z, num_nu).setConstant(1e-2);
  if (!hasConstant(program)) return y;
  // I - 2 H ⪰ ½ I, so the corner needs -2s - 2 H_00 + ... > 4 ‖h‖²/½.
  MatrixXd slack = -2.0 * extendedH(program, z * identity);
  slack.topLeftCorner(p, p) += MatrixXd::Identity(p, p);
  for (const PeakConstraint& peak : program.peaks()) slack += 1e-2 * peakGram(program, peak);
  const VectorXd h = slack.col(p).head(p);
  const double needed = h.dot(slack.topLeftCorner(p, p).llt().solve(h)) - slack(p, p);
  y(y.size() - 1) = -0.5 * (needed + 1.0);
  return y;
}

LmiProgram liftedProgram(const QuadraticProgram& program) {
  const int p = program.numAmplitudes(), m = order(program);
  const bool constant = hasConstant(program);
  const int count = m * (m + 1) / 2 - (constant ? 1 : 0);
  LmiProgram lmi;
  lmi.reward = VectorXd::Zero(count);
  LmiBlock lifted{MatrixXd::Zero(m, m), 0, count, {}};
  if (constant) lifted.constant(p, p) = 1.0;
  LmiBlock excess{-program.rightSide(), 0, count, {}};
  if (!program.homogeneous()) excess.constant += program.S_00();
  for (int a = 0; a < p; ++a) {
    for (int b = 0; b <= a; ++b) {
      if (a == b) lmi.reward(static_cast<Index>(excess.slopes.size())) = -0.5;
      excess.slopes.push_back((a == b ? 1.0 : 2.0) * program.S(a, b));
    }
  }
  for (int a = 0; constant && a < p; ++a) {
    excess.slopes.push_back(program.homogeneous() ? MatrixXd::Zero(program.size(), program.size())
                                                  : MatrixXd(2.0 * program.S_0(a)));
  }
  lmi.blocks.push_back(std::move(lifted));
  lmi.blocks.push_back(std::move(excess));
  for (const PeakConstraint& peak : program.peaks()) {
    const MatrixXd Q = peakGram(program, peak);
    LmiBlock room{MatrixXd::Constant(1, 1, 1.0 - (constant ? Q(p, p) : 0.0)), 0, count, {}};
    for (int a = 0; a < m; ++a) {
      for (int b = 0; b <= a && static_cast<int>(room.slopes.size()) < count; ++b)
        room.slopes.push_back(MatrixXd::Constant(1, 1, (a == b ? -1.0 : -2.0) * Q(a, b)));
    }
    lmi.blocks.push_back(std::move(room));
  }
  return lmi;
}

VectorXd liftedStart(const QuadraticProgram& program, const VectorXd& reference) {
  const int p = program.numAmplitudes();
  const VectorXd a = 1.5 * reference;
  const MatrixXd lifted = a * a.transpose() + MatrixXd::Identity(p, p) / p;
  VectorXd y(p * (p + 1) / 2 + (hasConstant(program) ? p : 0));
  Index next = 0;
  for (int i = 0; i < p; ++i) {
    for (int j = 0; j <= i; ++j) y(next++) = lifted(i, j);
  }
  if (hasConstant(program)) y.tail(p) = a;
  return y;
}

RelaxedSolution solveRelaxed(const QuadraticProgram& program, const VectorXd& reference, double gap,
                             double stop_above) {
  const int m = order(program);
  const bool lift = program.peaks().empty() && m * (m + 1) / 2 < numMultipliers(program);
  if (lift) {
    const LmiProgram lmi = liftedProgram(program);
    const VectorXd start = liftedStart(program, reference);
    // With x_0 the relaxation of 1.5 â may lie outside; the other program has a sure start.
    if (lmi.blocks[1].at(start).llt().info() == Eigen::Success) {
      const LmiSolution solution = solveLmi(lmi, start, gap);
      RelaxedSolution relaxed = fromLifted(program, lmi, solution);
      relaxed.nu.resize(0);
      relaxed.gap = solution.gap;
      relaxed.iterations = solution.iterations;
      relaxed.converged = solution.converged;
      return relaxed;
    }
  }
  const LmiSolution solution = solveLmi(dualProgram(program), dualStart(program), gap, stop_above);
  RelaxedSolution relaxed = fromDual(program, solution);
  relaxed.gap = solution.gap;
  relaxed.iterations = solution.iterations;
  relaxed.converged = solution.converged;
  return relaxed;
}

}  // namespace explore_opt
