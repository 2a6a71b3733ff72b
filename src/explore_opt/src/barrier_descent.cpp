#include "barrier_descent.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShrink = 0.2;
constexpr int kStepsALevel = 40;

class Barrier {
 public:
  Barrier(const QuadraticProgram& program, double mu) : program_(program), mu_(mu) {}

  /// Infinite outside.
  double value(const VectorXd& a) const {
    const Eigen::LLT<MatrixXd> llt(program_.N(a) - program_.rightSide());
    if (llt.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
    double f = 0.5 * a.squaredNorm() - 2.0 * mu_ * llt.matrixLLT().diagonal().array().log().sum();
    for (const PeakConstraint& peak : program_.peaks()) {
      const double room = peak.room(a);
      if (!(room > 0.0)) return std::numeric_limits<double>::infinity();
      f -= 0.5 * mu_ * std::log(room);
    }
    return std::isfinite(f) ? f : std::numeric_limits<double>::infinity();
  }

  void derivatives(const VectorXd& a, VectorXd& gradient, MatrixXd& hessian) const {
    const Index p = a.size(), n = program_.size();
    const Eigen::LLT<MatrixXd> llt(program_.N(a) - program_.rightSide());
    MatrixXd white(n * n, p);  // L⁻¹ S_i L⁻ᵀ: their products are tr(W S_i W S_j)
    gradient = a;
    for (int i = 0; i < p; ++i) {
      const MatrixXd half = llt.matrixL().solve(program_.derivative(a, i));
      const MatrixXd both = llt.matrixL().solve(half.transpose());
      gradient(i) -= mu_ * both.trace();
      white.col(i) = both.reshaped();
    }
    const MatrixXd W = llt.solve(MatrixXd::Identity(n, n));
    hessian = mu_ * (white.transpose() * white - 2.0 * program_.H(W));
    hessian.diagonal().array() += 1.0;
    for (const PeakConstraint& peak : program_.peaks()) {
      const double room = peak.room(a);
      const VectorXd slope = 2.0 * peak.rows.transpose() * (peak.rows * a + peak.offset);
      gradient += 0.5 * mu_ / room * slope;
      hessian += 0.5 * mu_ / room *
                 (2.0 * peak.rows.transpose() * peak.rows + slope * slope.transpose() / room);
    }
  }

  /// To a minimiser: Newton's steps until the decrement is small beside μ.
  VectorXd minimiser(VectorXd a) const {
    double f = value(a);
    for (int i = 0; i < kStepsALevel && std::isfinite(f); ++i) {
      const Step newton = stepFrom(a);
      if (!newton.direction.allFinite() || !(newton.slope < -1e-4 * mu_)) break;
      double t = 1.0, next = value(a + newton.direction);
      while (!(next <= f + 1e-3 * t * newton.slope) && t > 1e-8) {
        t *= 0.5;
        next = value(a + t * newton.direction);
      }
      if (!(next < f)) break;
      a += t * newton.direction;
      f = next;
    }
    return a;
  }

  /// Where the values no longer tell points apart: whole steps while the slope shrinks. It enters
  /// the multiplier's stationarity over the root of the curvature, about 1/μ.
  VectorXd sharpened(VectorXd a) const {
    Step newton = stepFrom(a);
    for (int i = 0; i < 8 && newton.direction.allFinite(); ++i) {
      const VectorXd b = a + newton.direction;
      if (!std::isfinite(value(b))) break;
      const Step next = stepFrom(b);
      if (!(-next.slope < -0.25 * newton.slope)) break;
      a = b;
      newton = next;
    }
    return a;
  }

  MatrixXd multiplier(const VectorXd& a) const {
    const MatrixXd S = program_.N(a) - program_.rightSide();
    return mu_ * S.llt().solve(MatrixXd::Identity(S.rows(), S.cols()));
  }
  VectorXd peakMultipliers(const VectorXd& a) const {
    VectorXd nu(static_cast<Index>(program_.peaks().size()));
    for (Index k = 0; k < nu.size(); ++k)
      nu(k) = mu_ / program_.peaks()[static_cast<std::size_t>(k)].room(a);
    return nu;
  }

 private:
  struct Step {
    VectorXd direction;
    double slope;  ///< -(Newton's decrement)²
  };

  Step stepFrom(const VectorXd& a) const {
    VectorXd gradient;
    MatrixXd hessian;
    derivatives(a, gradient, hessian);
    const quad_support::SymmetricEigen eigen(hessian);
    const VectorXd sizes = eigen.values.cwiseAbs();
    const VectorXd curvature = sizes.cwiseMax(1e-12 * sizes.maxCoeff());
    const VectorXd direction =
        -eigen.vectors * (eigen.vectors.transpose() * gradient).cwiseQuotient(curvature);
    return {direction, gradient.dot(direction)};
  }

  const QuadraticProgram& program_;
  double mu_;
};

}  // namespace

BarrierPoint descendBarrier(const QuadraticProgram& program, const VectorXd& start, double gap) {
  BarrierPoint point;
  const double order = program.size() + 0.5 * static_cast<double>(program.peaks().size());
  const double cost = 0.5 * start.squaredNorm(), last = gap * cost / order;
  double mu = 0.1 * cost / order;
  if (!std::isfinite(Barrier(program, mu).value(start))) return point;
  point.a = start;
  for (;;) {
    const Barrier barrier(program, mu);
    point.a = barrier.minimiser(point.a);
    if (mu <= last) point.a = barrier.sharpened(point.a);
    point.Z = barrier.multiplier(point.a);
    point.nu = barrier.peakMultipliers(point.a);
    if (mu <= last) return point;
    mu = std::max(last, kShrink * mu);
  }
}

}  // namespace explore_opt
