#include "quad_experiment/design_memory.hpp"

#include "quad_support/number_format.hpp"

namespace quad_experiment {
namespace {

void append(std::string& text, double value) {
  quad_support::appendShortest(text, value);
  text += ' ';
}

void append(std::string& text, const Eigen::MatrixXd& matrix) {
  append(text, static_cast<double>(matrix.rows()));
  for (Eigen::Index i = 0; i < matrix.size(); ++i) append(text, matrix.data()[i]);
}

/// Everything of the problem, exactly.
std::string textOf(const explore_opt::ExplorationProblem& p, explore_opt::DesignMethod method) {
  std::string text = explore_opt::toString(method) + " " + explore_opt::toString(p.phase) + " ";
  append(text, p.lines.num_samples);
  for (const int harmonic : p.lines.harmonics) append(text, harmonic);
  text += "| ";
  for (const double frequency : p.lines.frequencies) append(text, frequency);
  append(text, p.gamma_w);
  append(text, p.A);
  append(text, p.B);
  append(text, p.D_des);
  append(text, p.x0);
  append(text, p.K);
  return text;
}

}  // namespace

const explore_opt::DesignResult& DesignMemory::design(
    const explore_opt::ExplorationProblem& problem, explore_opt::DesignMethod method) {
  const std::string key = textOf(problem, method);
  const auto known = designs_.find(key);
  if (known != designs_.end()) return known->second;
  explore_opt::DesignOptions options;
  options.method = method;
  explore_opt::DesignResult result = explore_opt::designExploration(problem, options);
  result.iterations.clear();
  ++computed_;
  if (order_.size() == capacity_) {
    designs_.erase(order_.front());
    order_.pop_front();
  }
  order_.push_back(key);
  return designs_.emplace(key, std::move(result)).first->second;
}

}  // namespace quad_experiment
