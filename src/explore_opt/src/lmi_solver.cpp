#include "lmi_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

#include "quad_support/linear_algebra.hpp"

namespace explore_opt {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxIterations = 80;
constexpr double kRootTwo = 1.4142135623730950488;

Index triangle(Index n) { return n * (n + 1) / 2; }

/// The lower triangle row by row, off-diagonal entries times √2: products of two such vectors are
/// traces of products.
void pack(const MatrixXd& m, Eigen::Ref<VectorXd> out) {
  Index next = 0;
  for (Index i = 0; i < m.rows(); ++i) {
    for (Index j = 0; j < i; ++j) out(next++) = kRootTwo * m(i, j);
    out(next++) = m(i, i);
  }
}

/// One block at the current point, seen in the coordinates where S and X are the same diagonal
/// matrix: Gᵀ S G = G⁻¹ X G⁻ᵀ = diag(λ).
struct ScaledBlock {
  MatrixXd G;
  VectorXd lambda;
  MatrixXd columns;  ///< Gᵀ A_k G, packed, one a variable
  MatrixXd dS, dX;   ///< the step, scaled
};

std::optional<ScaledBlock> scaled(const LmiBlock& block, const MatrixXd& S, const MatrixXd& X) {
  const Eigen::LLT<MatrixXd> llt_S(S), llt_X(X);
  if (llt_S.info() != Eigen::Success || llt_X.info() != Eigen::Success) return std::nullopt;
  const MatrixXd L_X = llt_X.matrixL();
  const MatrixXd product = L_X.transpose() * llt_S.matrixL().toDenseMatrix();
  const Eigen::BDCSVD<MatrixXd> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  ScaledBlock scaled;
  scaled.lambda = svd.singularValues();
  if (!(scaled.lambda.minCoeff() > 0.0) || !scaled.lambda.allFinite()) return std::nullopt;
  scaled.G = L_X * svd.matrixU() * scaled.lambda.cwiseSqrt().cwiseInverse().asDiagonal();
  const MatrixXd& G = scaled.G;
  const Index n = block.size();
  scaled.columns.resize(triangle(n), block.count);
  if (!block.slopes.empty()) {
    for (int k = 0; k < block.count; ++k) {
      const MatrixXd half = block.slopes[static_cast<std::size_t>(k)] * G;
      pack(G.transpose() * half, scaled.columns.col(k));
    }
    return scaled;
  }
  int k = 0;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j <= i && k < block.count; ++j, ++k) {
      MatrixXd image = G.row(i).transpose() * G.row(j);
      if (i != j) image += image.transpose().eval();
      pack(image, scaled.columns.col(k));
    }
  }
  return scaled;
}

MatrixXd unpack(const VectorXd& packed, Index n) {
  MatrixXd m(n, n);
  Index next = 0;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) m(i, j) = m(j, i) = packed(next++) / kRootTwo;
    m(i, i) = packed(next++);
  }
  return m;
}

/// Largest t <= 1 with diag(λ) + t d ⪰ 0, less a little.
double stepTo(const VectorXd& lambda, const MatrixXd& d, double fraction) {
  const VectorXd root = lambda.cwiseSqrt().cwiseInverse();
  const double least =
      quad_support::symmetricEigenvalues(root.asDiagonal() * d * root.asDiagonal())(0);
  return least < -fraction ? fraction / -least : 1.0;
}

/// All blocks at one point, and the steps from it.
class Point {
 public:
  Point(const LmiProgram& program, std::vector<ScaledBlock> blocks)
      : program_(program), blocks_(std::move(blocks)) {
    Index rows = 0;
    for (const ScaledBlock& b : blocks_) {
      rows += b.columns.rows();
      order_ += b.lambda.size();
    }
    MatrixXd root = MatrixXd::Zero(rows, program.reward.size());
    Index next = 0;
    for (std::size_t j = 0; j < blocks_.size(); ++j) {
      root.block(next, program.blocks[j].first, blocks_[j].columns.rows(),
                 blocks_[j].columns.cols()) = blocks_[j].columns;
      next += blocks_[j].columns.rows();
    }
    const Index m = root.cols();
    R_ = Eigen::HouseholderQR<Eigen::Ref<MatrixXd>>(root)
             .matrixQR()
             .topRows(m)
             .triangularView<Eigen::Upper>();
  }

  double mu() const {
    double sum = 0.0;
    for (const ScaledBlock& b : blocks_) sum += b.lambda.squaredNorm();
    return sum / static_cast<double>(order_);
  }

  /// Newton's step towards λ∘λ = σμ, less `correction` (the products of the predictor's steps).
  VectorXd step(double target, bool correct) {
    std::vector<MatrixXd> wanted;  // dS + dX, scaled
    VectorXd right = program_.reward;
    for (std::size_t j = 0; j < blocks_.size(); ++j) {
      ScaledBlock& b = blocks_[j];
      const Index n = b.lambda.size();
      MatrixXd r = MatrixXd::Zero(n, n);
      if (correct) r = -0.5 * (b.dS * b.dX + b.dX * b.dS);
      r.diagonal().array() += target;
      for (Index i = 0; i < n; ++i) {
        for (Index k = 0; k < n; ++k) r(i, k) *= 2.0 / (b.lambda(i) + b.lambda(k));
      }
      VectorXd packed(b.columns.rows());
      pack(r, packed);  // without -λ, whose product with the columns is part of the residual
      right.segment(program_.blocks[j].first, b.columns.cols()) += b.columns.transpose() * packed;
      r.diagonal() -= b.lambda;
      wanted.push_back(std::move(r));
    }
    const MatrixXd& R = R_;
    const auto upper = R.triangularView<Eigen::Upper>();
    const VectorXd dy = upper.solve(upper.transpose().solve(right).eval());
    for (std::size_t j = 0; j < blocks_.size(); ++j) {
      ScaledBlock& b = blocks_[j];
      b.dS = unpack(b.columns * dy.segment(program_.blocks[j].first, b.columns.cols()),
                    b.lambda.size());
      b.dX = wanted[j] - b.dS;
    }
    return dy;
  }

  double longestInY(double fraction) const {
    double t = 1.0;
    for (const ScaledBlock& b : blocks_) t = std::min(t, stepTo(b.lambda, b.dS, fraction));
    return t;
  }
  double longestInX(double fraction) const {
    double t = 1.0;
    for (const ScaledBlock& b : blocks_) t = std::min(t, stepTo(b.lambda, b.dX, fraction));
    return t;
  }

  /// μ after steps of these lengths.
  double muAfter(double t_y, double t_x) const {
    double sum = 0.0;
    for (const ScaledBlock& b : blocks_) {
      const MatrixXd diagonal = b.lambda.asDiagonal();
      sum += (diagonal + t_y * b.dS).cwiseProduct(diagonal + t_x * b.dX).sum();
    }
    return sum / static_cast<double>(order_);
  }

  MatrixXd changeOfX(std::size_t j) const {
    const MatrixXd d = blocks_[j].G * blocks_[j].dX * blocks_[j].G.transpose();
    return 0.5 * (d + d.transpose());
  }

 private:
  const LmiProgram& program_;
  std::vector<ScaledBlock> blocks_;
  Index order_ = 0;
  MatrixXd R_;
};

double trace(const LmiBlock& block, int k, const MatrixXd& X) {
  if (!block.slopes.empty()) return block.slopes[static_cast<std::size_t>(k)].cwiseProduct(X).sum();
  Index i = 0;
  while (triangle(i + 1) <= k) ++i;
  const Index j = k - triangle(i);
  return i == j ? X(i, i) : 2.0 * X(i, j);
}

void measure(const LmiProgram& program, LmiSolution& solution) {
  VectorXd residual = program.reward;
  double gap = 0.0;
  for (std::size_t j = 0; j < program.blocks.size(); ++j) {
    const LmiBlock& block = program.blocks[j];
    const MatrixXd& X = solution.multipliers[j];
    gap += X.cwiseProduct(block.at(solution.y)).sum();
    for (int k = 0; k < block.count; ++k) residual(block.first + k) += trace(block, k, X);
  }
  solution.gap = gap;
  solution.residual = residual.cwiseAbs().maxCoeff();
}

std::optional<Point> pointAt(const LmiProgram& program, const LmiSolution& solution) {
  std::vector<ScaledBlock> blocks;
  for (std::size_t j = 0; j < program.blocks.size(); ++j) {
    auto block =
        scaled(program.blocks[j], program.blocks[j].at(solution.y), solution.multipliers[j]);
    if (!block) return std::nullopt;
    blocks.push_back(std::move(*block));
  }
  return Point(program, std::move(blocks));
}

}  // namespace

MatrixXd LmiBlock::change(const VectorXd& d) const {
  MatrixXd sum = MatrixXd::Zero(size(), size());
  if (!slopes.empty()) {
    for (int k = 0; k < count; ++k) sum += d(first + k) * slopes[static_cast<std::size_t>(k)];
    return sum;
  }
  int k = 0;
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j <= i && k < count; ++j, ++k) sum(i, j) = sum(j, i) = d(first + k);
  }
  return sum;
}

MatrixXd LmiBlock::at(const VectorXd& y) const { return constant + change(y); }

LmiSolution solveLmi(const LmiProgram& program, const VectorXd& start, double gap,
                     double stop_above) {
  LmiSolution solution;
  solution.y = start;
  for (const LmiBlock& block : program.blocks) {
    const MatrixXd S = block.at(start);
    const MatrixXd inverse = S.llt().solve(MatrixXd::Identity(S.rows(), S.cols()));
    solution.multipliers.push_back(0.5 * (inverse + inverse.transpose()));
  }
  measure(program, solution);
  while (solution.iterations < kMaxIterations) {
    auto point = pointAt(program, solution);
    if (!point) break;
    ++solution.iterations;
    const double mu = point->mu();
    point->step(0.0, false);
    const double affine = point->muAfter(point->longestInY(1.0), point->longestInX(1.0));
    const double centring = std::pow(std::clamp(affine / mu, 1e-3, 1.0), 3);
    const VectorXd dy = point->step(centring * mu, true);
    const double t_y = point->longestInY(0.98), t_x = point->longestInX(0.98);
    if (!dy.allFinite() || std::max(t_y, t_x) < 1e-6) break;
    LmiSolution next = solution;
    next.y += t_y * dy;
    for (std::size_t j = 0; j < next.multipliers.size(); ++j)
      next.multipliers[j] += t_x * point->changeOfX(j);
    measure(program, next);
    if (!std::isfinite(next.gap) || !(next.gap > 0.0)) break;
    solution = std::move(next);
    solution.converged = solution.gap <= gap && solution.residual <= std::max(gap, 1e-12);
    if (solution.converged || program.reward.dot(solution.y) > stop_above) break;
  }
  return solution;
}

}  // namespace explore_opt
