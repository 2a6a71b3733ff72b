#include "barrier_descent.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "constants.hpp"
#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShrink = 0.2;
/// How far a level of μ is followed: on the way only near enough for the next one.
struct Effort {
  int steps;
  double decrement;  ///< square of Newton's, in units of μ, to stop at
};
/// On the way Newton's steps converge from a decrement below one; in a curved valley, where they
/// never do, 15 lose nothing that 40 would find (test_random_family). At the end 1e-4 leaves 1e-2
/// of the gap's n μ at most.
constexpr Effort kOnTheWay{15, 0.1}, kAtAnEnd{40, 1e-4};
/// Multipliers are taken at a level this many times the last one (two steps before it). S(a) has
/// the size of μ in the directions that bind, and loses to rounding what it is smaller than one: at
/// the end six digits would be left for Z, which satisfiesKkt() asks for.
constexpr double kMultiplierLevel = 25.0;
static_assert(kMultiplierLevel >= 1.0 / (kShrink * kShrink) - 1e-9);

/// Of a Cholesky factor, by its pivots: their squares, up to 1e10 apart, leave Newton's step six
/// digits.
bool isWellScaled(const Eigen::LLT<MatrixXd>& llt) {
  const auto pivots = llt.matrixLLT().diagonal();
  return pivots.minCoeff() > 1e-5 * pivots.maxCoeff();
}

/// It keeps its memory from one evaluation to the next.
class Barrier {
 public:
  explicit Barrier(const QuadraticProgram& program) : program_(program) {
    const Index n = program.size(), p = program.numAmplitudes();
    white_.resize(n, n * p);
    for (MatrixXd* m : {&S_, &W_}) m->resize(n, n);
    llt_ = Eigen::LLT<MatrixXd>(n);
    newton_ = Eigen::LLT<MatrixXd>(p);
    for (VectorXd* v : {&slope_, &gradient_, &curvature_, &turned_, &step_, &next_step_, &trial_})
      v->resize(p);
    for (MatrixXd* m : {&hessian_, &vectors_, &H_}) m->resize(p, p);
  }
  void setWeight(double mu) { mu_ = mu; }

  /// Infinite outside.
  double value(const VectorXd& a) {
    if (!factorise(a)) return kInfinity;
    double f = 0.5 * a.squaredNorm() - 2.0 * mu_ * llt_.matrixLLT().diagonal().array().log().sum();
    for (const PeakConstraint& peak : program_.peaks()) {
      const double room = peak.room(a);
      if (!(room > 0.0)) return kInfinity;
      f -= 0.5 * mu_ * std::log(room);
    }
    return std::isfinite(f) ? f : kInfinity;
  }

  /// Towards a minimiser, by Newton's steps.
  void minimise(VectorXd& a, const Effort& effort) {
    double f = value(a);
    for (int i = 0; i < effort.steps && std::isfinite(f); ++i) {
      const double slope = stepFrom(a, step_);
      if (!step_.allFinite() || !(slope < -effort.decrement * mu_)) break;
      double t = 1.0;
      trial_ = a + step_;
      double next = value(trial_);
      while (!(next <= f + 1e-3 * t * slope) && t > 1e-8) {
        t *= 0.5;
        trial_ = a + t * step_;
        next = value(trial_);
      }
      if (!(next < f)) break;
      a.swap(trial_);
      f = next;
    }
  }

  /// Where the values no longer tell points apart: whole steps while the slope shrinks. It enters
  /// the multiplier's stationarity over the root of the curvature, about 1/μ.
  void sharpen(VectorXd& a) {
    double slope = stepFrom(a, step_);
    for (int i = 0; i < 8 && step_.allFinite(); ++i) {
      trial_ = a + step_;
      if (!std::isfinite(value(trial_))) break;
      const double next = stepFrom(trial_, next_step_);
      if (!(-next < -0.25 * slope)) break;
      a.swap(trial_);
      step_.swap(next_step_);
      slope = next;
    }
  }

  MatrixXd multiplier(const VectorXd& a) {
    factorise(a);
    return mu_ * llt_.solve(MatrixXd::Identity(S_.rows(), S_.cols()));
  }
  VectorXd peakMultipliers(const VectorXd& a) const {
    VectorXd nu(static_cast<Index>(program_.peaks().size()));
    for (Index k = 0; k < nu.size(); ++k)
      nu(k) = mu_ / program_.peaks()[static_cast<std::size_t>(k)].room(a);
    return nu;
  }

 private:
  bool factorise(const VectorXd& a) {
    program_.factor(a, F_);
    program_.N(F_, S_);
    S_ -= program_.rightSide();
    llt_.compute(S_);
    return llt_.info() == Eigen::Success;
  }

  /// gradient_, hessian_
  void differentiate(const VectorXd& a) {
    const Index p = a.size(), n = program_.size();
    factorise(a);
    gradient_ = a;
    program_.derivatives(F_, white_);  // L⁻¹ S_i L⁻ᵀ: their products are tr(W S_i W S_j)
    llt_.matrixL().solveInPlace(white_);
    for (Index i = 0; i < p; ++i) white_.middleCols(n * i, n).transposeInPlace();
    llt_.matrixL().solveInPlace(white_);
    for (Index i = 0; i < p; ++i) gradient_(i) -= mu_ * white_.middleCols(n * i, n).trace();
    W_.setIdentity();
    llt_.solveInPlace(W_);
    program_.H(W_, H_);
    const Eigen::Map<const MatrixXd> products(white_.data(), n * n, p);
    hessian_.noalias() = products.transpose() * products;
    hessian_ = mu_ * (hessian_ - 2.0 * H_);
    hessian_.diagonal().array() += 1.0;
    for (const PeakConstraint& peak : program_.peaks()) addPeak(peak, a);
  }

  void addPeak(const PeakConstraint& peak, const VectorXd& a) {
    const double room = peak.room(a), weight = 0.5 * mu_ / room;
    slope_.setZero();
    for (Index r = 0; r < peak.rows.rows(); ++r) {
      slope_ += 2.0 * peak.value(r, a) * peak.rows.row(r).transpose();
      for (Index k = 0; k < a.size(); ++k)
        hessian_.col(k) += 2.0 * weight * peak.rows(r, k) * peak.rows.row(r).transpose();
    }
    gradient_ += weight * slope_;
    for (Index k = 0; k < a.size(); ++k) hessian_.col(k) += weight / room * slope_(k) * slope_;
  }

  /// Newton's step with the moduli of the curvatures. @returns -(its decrement)²
  double stepFrom(const VectorXd& a, VectorXd& step) {
    differentiate(a);
    newton_.compute(hessian_);
    if (newton_.info() == Eigen::Success && isWellScaled(newton_)) {  // convex here: no moduli
      step = -gradient_;
      newton_.solveInPlace(step);
      return gradient_.dot(step);
    }
    quad_support::symmetricEigen(hessian_, curvature_, vectors_);
    curvature_ = curvature_.cwiseAbs();
    const double least = 1e-12 * curvature_.maxCoeff();
    turned_.noalias() = vectors_.transpose() * gradient_;
    turned_ = -turned_.cwiseQuotient(curvature_.cwiseMax(least));
    step.noalias() = vectors_ * turned_;
    return gradient_.dot(step);
  }

  const QuadraticProgram& program_;
  double mu_ = 1.0;
  Eigen::LLT<MatrixXd> llt_, newton_;
  MatrixXd F_, S_, W_, white_, H_, hessian_, vectors_;
  VectorXd slope_, gradient_, curvature_, turned_, step_, next_step_, trial_;
};

}  // namespace

BarrierPoint descendBarrier(const QuadraticProgram& program, const VectorXd& start, double gap) {
  BarrierPoint point;
  const double order = program.size() + 0.5 * static_cast<double>(program.peaks().size());
  const double cost = 0.5 * start.squaredNorm(), last = gap * cost / order;
  double mu = 0.1 * cost / order;
  Barrier barrier(program);
  barrier.setWeight(mu);
  if (!std::isfinite(barrier.value(start))) return point;
  point.a = start;
  for (;;) {
    const bool multiplier = point.Z.size() == 0 && mu <= kMultiplierLevel * last;
    barrier.minimise(point.a, multiplier || mu <= last ? kAtAnEnd : kOnTheWay);
    if (multiplier) {
      barrier.sharpen(point.a);
      point.Z = barrier.multiplier(point.a);
      point.nu = barrier.peakMultipliers(point.a);
    }
    if (mu <= last) return point;
    mu = std::max(last, kShrink * mu);
    barrier.setWeight(mu);
  }
}

}  // namespace explore_opt
