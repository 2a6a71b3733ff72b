#include "explore_opt/baselines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "checks.hpp"
#include "constants.hpp"
#include "explore_opt/baseline_signals.hpp"
#include "explore_opt/classical_designs.hpp"
#include "explore_opt/signal_response.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

constexpr std::uint64_t kStream = 0x626173656c696e65;  // of this purpose alone

/// The signals of all experiments side by side, and what they cost as they are if the cost is on
/// the signal.
struct Trial {
  MatrixXd signals;
  double amplitude = 0.0;
};

struct Scaled {
  double cost = kInfinity, peak = kInfinity;
};

Scaled scaledOneWay(const ExplorationProblem& problem, const Trial& trial) {
  const double s = cheapestScale(problem, trial.signals);
  if (!std::isfinite(s)) return {};
  const MatrixXd signals = s * trial.signals;
  return {problem.cost == CostOn::kInput ? inputAmplitude(problem, signals) : s * trial.amplitude,
          signals.colwise().norm().maxCoeff()};
}

/// Away from rest a signal and its negative are not the same; the cheaper counts.
Scaled scaled(const ExplorationProblem& problem, const Trial& trial) {
  const Scaled one = scaledOneWay(problem, trial);
  if (problem.x0.size() == 0 || problem.x0.isZero(0.0)) return one;
  const Scaled other = scaledOneWay(problem, {-trial.signals, trial.amplitude});
  return other.cost < one.cost ? other : one;
}

BaselineCost summary(const std::string& name, const std::string& note, std::vector<Scaled> costs) {
  std::sort(costs.begin(), costs.end(),
            [](const Scaled& a, const Scaled& b) { return a.cost < b.cost; });
  const Scaled& median = costs[(costs.size() - 1) / 2];
  BaselineCost out;
  out.name = name;
  out.note = note;
  out.seeds = static_cast<int>(costs.size());
  out.failed = static_cast<int>(std::count_if(
      costs.begin(), costs.end(), [](const Scaled& c) { return !std::isfinite(c.cost); }));
  out.cost = median.cost;
  out.peak = median.peak;
  out.least = costs.front().cost;
  out.largest = costs.back().cost;
  return out;
}

std::vector<double> frequenciesOf(const SpectralLines& lines) {
  std::vector<double> f = lines.frequencies;
  for (const int h : lines.harmonics) f.push_back(static_cast<double>(h) / lines.num_samples);
  return f;
}

BaselineSpec specOf(const ExplorationProblem& problem, BaselineKind kind,
                    const BaselineOptions& options) {
  BaselineSpec spec;
  spec.kind = kind;
  spec.num_samples = problem.lines.num_samples;
  spec.num_inputs = problem.numInputs();
  spec.energy = spec.num_samples;
  spec.seed = options.seed;
  spec.stream = kStream;
  spec.lines = problem.lines;
  spec.line_phase = problem.phase == Phase::kSin ? Phase::kSin : Phase::kCos;
  const auto f = frequenciesOf(problem.lines);
  const double tick = 1.0 / spec.num_samples;
  const bool given = options.band_low != 0.0 || options.band_high != 0.0;
  spec.band_low = given ? options.band_low : *std::min_element(f.begin(), f.end());
  spec.band_high = given ? options.band_high
                         : std::min(0.5, *std::max_element(f.begin(), f.end()) + 1e-9 * tick);
  if (!given && spec.band_high - spec.band_low < tick)  // one line: the next harmonic too
    spec.band_high = std::min(0.5, spec.band_low + tick);
  return spec;
}

/// Another draw in each experiment, or the same signal again. Of signals made of lines the norm of
/// the amplitudes counts, as in the design; of others the norm on the grid of the same energy.
Trial trialOf(const ExplorationProblem& problem, BaselineSpec spec, int draw) {
  const Eigen::Index T = spec.num_samples;
  Trial trial{MatrixXd(spec.num_inputs, T * problem.experiments), 0.0};
  double square = 0.0;
  for (int i = 0; i < problem.experiments; ++i) {
    spec.run = static_cast<std::uint64_t>(draw) * static_cast<std::uint64_t>(problem.experiments) +
               static_cast<std::uint64_t>(i);
    const MatrixXd signal = baselineSignal(spec), amplitudes = baselineAmplitudes(spec);
    trial.signals.middleCols(i * T, T) = signal;
    square += std::pow(amplitudes.size() > 0 ? amplitudes.norm() : equivalentAmplitude(signal), 2);
  }
  trial.amplitude = std::sqrt(square / problem.experiments);
  return trial;
}

std::vector<Scaled> overSeeds(const ExplorationProblem& problem, const BaselineSpec& spec,
                              int seeds) {
  std::vector<Scaled> costs;
  for (int i = 0; i < seeds; ++i) costs.push_back(scaled(problem, trialOf(problem, spec, i)));
  return costs;
}

/// The hold whose median is cheapest, of 1, 2, 4, ... while 16 levels remain.
BaselineCost bestPrbs(const ExplorationProblem& problem, BaselineSpec spec, int seeds) {
  std::optional<BaselineCost> best;
  for (spec.hold = 1; !best || spec.hold * 16 <= spec.num_samples; spec.hold *= 2) {
    const BaselineCost cost = summary("prbs", fmt::format("each level held {} samples", spec.hold),
                                      overSeeds(problem, spec, seeds));
    if (!best || cost.cost < best->cost) best = cost;
  }
  return *best;
}

BaselineCost bestLine(const ExplorationProblem& problem, BaselineSpec spec) {
  std::optional<BaselineCost> best;
  const auto f = frequenciesOf(problem.lines);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const bool grid = !problem.lines.harmonics.empty();
    spec.lines = {spec.num_samples, {}, {}};
    if (grid) spec.lines.harmonics = {problem.lines.harmonics[i]};
    if (!grid) spec.lines.frequencies = {f[i]};
    const BaselineCost cost = summary("line", fmt::format("{:.4g} cycles/sample", f[i]),
                                      {scaled(problem, trialOf(problem, spec, 0))});
    if (!best || cost.cost < best->cost) best = cost;
  }
  return *best;
}

BaselineCost costOf(const ExplorationProblem& problem, BaselineKind kind,
                    const BaselineOptions& options) {
  const BaselineSpec spec = specOf(problem, kind, options);
  const int seeds = isRandom(kind) ? options.seeds : 1;
  if (kind == BaselineKind::kPrbs) return bestPrbs(problem, spec, seeds);
  if (kind == BaselineKind::kLine) return bestLine(problem, spec);
  const bool banded = kind == BaselineKind::kBandLimited || kind == BaselineKind::kChirp;
  const std::string note =
      banded ? fmt::format("{:.4g} to {:.4g} cycles/sample", spec.band_low, spec.band_high)
      : kind == BaselineKind::kWhite ? ""
                                     : "on the lines of the problem";
  return summary(toString(kind), note, overSeeds(problem, spec, seeds));
}

/// @param amplitudes  of every experiment one below the other, or of one that all repeat
BaselineCost costOfAmplitudes(const ExplorationProblem& problem, const std::string& name,
                              const MatrixXd& amplitudes) {
  if (amplitudes.size() == 0) return summary(name, "", {Scaled{}});
  const Eigen::Index T = problem.lines.num_samples,
                     rows = numCarriers(problem.lines, problem.phase);
  Trial trial{MatrixXd(problem.numInputs(), T * problem.experiments), 0.0};
  for (Eigen::Index i = 0; i < problem.experiments; ++i) {
    trial.signals.middleCols(i * T, T) = multisine(
        problem.lines, problem.phase, amplitudes.middleRows(i * rows % amplitudes.rows(), rows));
  }
  const auto given = static_cast<double>(amplitudes.rows() / rows);
  trial.amplitude = amplitudes.norm() / std::sqrt(given);
  return summary(name, "", {scaled(problem, trial)});
}

}  // namespace

std::vector<BaselineCost> compareBaselines(const ExplorationProblem& problem,
                                           const MatrixXd& amplitudes,
                                           const BaselineOptions& options) {
  validate(problem);
  const int carriers = numCarriers(problem.lines, problem.phase) * problem.experiments;
  requireShape(amplitudes, carriers, problem.numInputs(), "amplitudes");
  require(options.seeds >= 1 && options.seeds <= 100000, "seeds = {}; must be 1 to 100000",
          options.seeds);
  std::vector<BaselineCost> rows = {costOfAmplitudes(problem, "targeted", amplitudes)};
  for (const ClassicalCriterion criterion : allCriteria()) {
    rows.push_back(costOfAmplitudes(problem, toString(criterion),
                                    classicalDesign(problem, criterion, options.seed)));
  }
  for (const BaselineKind kind : allBaselines()) {
    const bool too_few = kind == BaselineKind::kMultisine &&
                         problem.lines.size() < problem.numInputs();  // a line for each input
    if (!too_few) rows.push_back(costOf(problem, kind, options));
  }
  return rows;
}

}  // namespace explore_opt
