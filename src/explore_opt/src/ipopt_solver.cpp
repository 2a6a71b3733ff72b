#include "ipopt_solver.hpp"

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using Eigen::VectorXd;
using Ipopt::Number;

SolverStatus statusOf(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return SolverStatus::kConverged;
    case Ipopt::Solved_To_Acceptable_Level:
      return SolverStatus::kAcceptable;
    case Ipopt::Search_Direction_Becomes_Too_Small:
    case Ipopt::Restoration_Failed:
    case Ipopt::Feasible_Point_Found:
      return SolverStatus::kStalled;
    case Ipopt::Maximum_Iterations_Exceeded:
      return SolverStatus::kIterationLimit;
    case Ipopt::Invalid_Option:  // an unknown linear solver is reported only here
      throw quad_support::EnvironmentError(
          "Ipopt refuses its options; is it built with the linear solver mumps?");
    default:
      return SolverStatus::kFailed;
  }
}

/// The program in Ipopt's words. Index lists are filled once, values copied in memory that stays.
/// Numbers that are not finite are "outside the domain": the linear solver behind Ipopt dies of
/// them.
class Adapter : public Ipopt::TNLP {
 public:
  Adapter(SmoothProgram& program, const SolverStart& start, SolverAnswer& answer)
      : program_(program),
        start_(start),
        answer_(answer),
        jacobian_(program.jacobianPositions()),
        hessian_(program.hessianPositions()) {}

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& nnz_jac, Ipopt::Index& nnz_hess,
                    IndexStyleEnum& style) override {
    n = program_.numVariables();
    m = program_.numConstraints();
    nnz_jac = static_cast<Ipopt::Index>(jacobian_.size());
    nnz_hess = static_cast<Ipopt::Index>(hessian_.size());
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Ipopt::Index n, Number* xl, Number* xu, Ipopt::Index m, Number* gl,
                       Number* gu) override {
    std::fill(xl, xl + n, -2e19);  // Ipopt's "no bound"
    std::fill(xu, xu + n, 2e19);
    std::fill(gl, gl + m, 0.0);
    const Ipopt::Index equalities = m - program_.numInequalities();
    std::fill(gu, gu + equalities, 0.0);
    std::fill(gu + equalities, gu + m, 2e19);
    return true;
  }

  bool get_starting_point(Ipopt::Index n, bool, Number* x, bool, Number* zl, Number* zu,
                          Ipopt::Index m, bool init_lambda, Number* lambda) override {
    std::copy(start_.x.data(), start_.x.data() + n, x);
    if (zl != nullptr) std::fill(zl, zl + n, 0.0);
    if (zu != nullptr) std::fill(zu, zu + n, 0.0);
    if (init_lambda) std::copy(start_.multipliers.data(), start_.multipliers.data() + m, lambda);
    return true;
  }

  bool eval_f(Ipopt::Index n, const Number* x, bool, Number& f) override {
    return program_.objective(read(x, n, x_), f) && std::isfinite(f);
  }

  bool eval_grad_f(Ipopt::Index n, const Number* x, bool, Number* g) override {
    values_.resize(n);
    return program_.gradient(read(x, n, x_), values_) && write(g);
  }

  bool eval_g(Ipopt::Index n, const Number* x, bool, Ipopt::Index m, Number* c) override {
    values_.resize(m);
    program_.constraints(read(x, n, x_), values_);
    return write(c);
  }

  bool eval_jac_g(Ipopt::Index n, const Number* x, bool, Ipopt::Index, Ipopt::Index nnz,
                  Ipopt::Index* rows, Ipopt::Index* cols, Number* out) override {
    if (out == nullptr) return positions(jacobian_, rows, cols);
    values_.resize(nnz);
    program_.jacobian(read(x, n, x_), values_);
    return write(out);
  }

  bool eval_h(Ipopt::Index n, const Number* x, bool, Number weight, Ipopt::Index m,
              const Number* lambda, bool, Ipopt::Index nnz, Ipopt::Index* rows, Ipopt::Index* cols,
              Number* out) override {
    if (out == nullptr) return positions(hessian_, rows, cols);
    values_.resize(nnz);
    return program_.hessian(read(x, n, x_), weight, read(lambda, m, multipliers_), values_) &&
           write(out);
  }

  void finalize_solution(Ipopt::SolverReturn, Ipopt::Index n, const Number* x, const Number*,
                         const Number*, Ipopt::Index m, const Number*, const Number* lambda, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    read(x, n, answer_.x);
    read(lambda, m, answer_.multipliers);
  }

 private:
  static const VectorXd& read(const Number* values, Ipopt::Index n, VectorXd& into) {
    return into = Eigen::Map<const VectorXd>(values, n);
  }

  bool write(Number* out) const {
    std::copy(values_.data(), values_.data() + values_.size(), out);
    return values_.allFinite();
  }

  static bool positions(const Positions& from, Ipopt::Index* rows, Ipopt::Index* cols) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      rows[i] = from[i].first;
      cols[i] = from[i].second;
    }
    return true;
  }

  SmoothProgram& program_;
  const SolverStart& start_;
  SolverAnswer& answer_;
  Positions jacobian_, hessian_;
  VectorXd x_, multipliers_, values_;
};

}  // namespace

struct IpoptSolver::Implementation {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
};

IpoptSolver::IpoptSolver(double tolerance, int max_iterations)
    : implementation_(new Implementation) {
  const auto options = implementation_->application->Options();
  options->SetIntegerValue("print_level", 0);
  options->SetStringValue("sb", "yes");
  options->SetStringValue("linear_solver", "mumps");
  options->SetNumericValue("tol", tolerance);
  options->SetIntegerValue("max_iter", max_iterations);
  options->SetStringValue("nlp_scaling_method", "none");  // the programs come scaled
  std::istringstream no_options_file;
  if (implementation_->application->Initialize(no_options_file) != Ipopt::Solve_Succeeded) {
    throw quad_support::EnvironmentError("Ipopt cannot be initialised");
  }
}

IpoptSolver::~IpoptSolver() = default;

SolverAnswer IpoptSolver::solve(SmoothProgram& program, const SolverStart& start) {
  SolverAnswer answer;
  if (!start.x.allFinite() || !start.multipliers.allFinite()) return answer;
  auto& application = *implementation_->application;
  const bool warm = start.multipliers.size() > 0;
  application.Options()->SetStringValue("warm_start_init_point", warm ? "yes" : "no");
  const Ipopt::SmartPtr<Ipopt::TNLP> adapter = new Adapter(program, start, answer);
  answer.status = statusOf(application.OptimizeTNLP(adapter));
  if (Ipopt::IsValid(application.Statistics()))
    answer.iterations = application.Statistics()->IterationCount();
  if (answer.x.size() > 0 && !answer.x.allFinite()) answer.x.resize(0);
  if (answer.x.size() == 0) answer.status = SolverStatus::kFailed;
  return answer;
}

}  // namespace explore_opt
