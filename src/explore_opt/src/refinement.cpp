#include "refinement.hpp"

#include <cmath>
#include <limits>

#include "constants.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

constexpr int kRefinementSteps = 6;

/// An unevaluated sum high + low of two doubles (Dekker 1971).
struct Twofold {
  double high = 0.0, low = 0.0;

  void add(double value) {
    const double sum = high + value, part = sum - high;
    low += (high - (sum - part)) + (value - part);
    high = sum;
  }
  void addProduct(double a, double b) {
    const double product = a * b;
    low += std::fma(a, b, -product);
    add(product);
  }
  double rounded() const { return high + low; }
};

/// B - A X, as sums of two doubles.
struct TwofoldMatrix {
  MatrixXd high, low;
};

TwofoldMatrix residualOf(const MatrixXd& A, const MatrixXd& B, const MatrixXd& X) {
  TwofoldMatrix r{MatrixXd(B.rows(), B.cols()), MatrixXd(B.rows(), B.cols())};
  for (Index j = 0; j < B.cols(); ++j) {
    for (Index k = 0; k < B.rows(); ++k) {
      Twofold sum;
      sum.add(B(k, j));
      for (Index i = 0; i < A.cols(); ++i) sum.addProduct(-A(k, i), X(i, j));
      r.high(k, j) = sum.rounded();
      r.low(k, j) = sum.low - (r.high(k, j) - sum.high);
    }
  }
  return r;
}

MatrixXd gradientOf(const MatrixXd& A, const TwofoldMatrix& r) {
  MatrixXd g(A.cols(), r.high.cols());
  for (Index j = 0; j < g.cols(); ++j) {
    for (Index i = 0; i < g.rows(); ++i) {
      Twofold sum;
      for (Index k = 0; k < A.rows(); ++k) {
        sum.addProduct(A(k, i), r.high(k, j));
        sum.low += A(k, i) * r.low(k, j);
      }
      g(i, j) = sum.rounded();
    }
  }
  return g;
}

}  // namespace

Eigen::VectorXd exactScales(const MatrixXd& m) {
  Eigen::VectorXd scales = m.colwise().norm();
  for (double& s : scales) s = s > 0.0 ? std::exp2(std::round(std::log2(s))) : 1.0;
  return scales;
}

RefinedSolution refine(const MatrixXd& A, const MatrixXd& B, const MatrixXd& R,
                       const MatrixXd& solution) {
  const auto upper = R.triangularView<Eigen::Upper>();
  MatrixXd X = solution;
  TwofoldMatrix r = residualOf(A, B, X);
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kRefinementSteps; ++step) {
    const MatrixXd half = upper.transpose().solve(gradientOf(A, r));
    const MatrixXd correction = upper.solve(half);
    const double size = correction.norm();
    if (!(size < 0.5 * last) || size == 0.0) break;
    last = size;
    X += correction;
    r = residualOf(A, B, X);
    if (size <= std::numeric_limits<double>::epsilon() * X.norm()) break;
  }
  return {X, r.high};
}

}  // namespace explore_opt
