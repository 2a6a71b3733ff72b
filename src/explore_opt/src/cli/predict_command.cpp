#include <fmt/core.h>

#include "commands.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/signal_response.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt {

const char* const kPredictHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt design problem.json --out design.json
  explore_opt predict problem.json design.json --out prediction.csv
  explore_opt identify prediction.csv --states x1,x2 --inputs u1 --gamma-w 20 --D 99.999
A table k,x1,...,u1,... of the nominal system without noise: T+1 rows, the last one without inputs. u is what the plant
gets, feedback K included. The design may be the answer of `design` or its amplitudes alone. With several experiments the
table begins with their number, run; --run 2 writes the second alone, for `identify run1.csv run2.csv ...`.
Exit code 0: done; 2: bad input.)";
namespace {

/// Rows of one experiment; with several, each begins with its number.
void appendRows(std::string& text, const std::string& begin, const NominalExperiment& run) {
  for (Eigen::Index k = 0; k < run.X.cols(); ++k) {
    text += begin + std::to_string(k);
    for (Eigen::Index i = 0; i < run.X.rows(); ++i) {
      text += ',';
      quad_support::appendShortest(text, run.X(i, k));
    }
    for (Eigen::Index j = 0; j < run.U.rows(); ++j) {
      text += ',';
      if (k < run.U.cols()) quad_support::appendShortest(text, run.U(j, k));
    }
    text += '\n';
  }
}

std::string toCsv(const ExplorationProblem& problem, const Eigen::MatrixXd& amplitudes, int only) {
  std::string text = problem.experiments > 1 && only == 0 ? "run,k" : "k";
  for (int i = 1; i <= problem.numStates(); ++i) text += ",x" + std::to_string(i);
  for (int j = 1; j <= problem.numInputs(); ++j) text += ",u" + std::to_string(j);
  text += '\n';
  const Eigen::Index rows = amplitudes.rows() / problem.experiments;
  for (int i = 0; i < problem.experiments; ++i) {
    if (only != 0 && only != i + 1) continue;
    const bool numbered = problem.experiments > 1 && only == 0;
    appendRows(text, numbered ? std::to_string(i + 1) + "," : "",
               simulateNominal(problem, multisine(problem.lines, problem.phase,
                                                  amplitudes.middleRows(i * rows, rows))));
  }
  return text;
}

}  // namespace

int runPredict(const PredictSettings& settings) {
  const ExplorationProblem problem =
      problemFromJson(quad_support::readFile(settings.problem), settings.problem);
  if (settings.run < 0 || settings.run > problem.experiments) {
    throw quad_support::DataError(
        fmt::format("--run {}; must be 0 (all) or one of the experiments 1..{} of {}", settings.run,
                    problem.experiments, settings.problem));
  }
  const Eigen::MatrixXd amplitudes =
      amplitudesFromJson(quad_support::readFile(settings.design), settings.design, problem);
  writeAnswer(settings.out, toCsv(problem, amplitudes, settings.run));
  return quad_support::kDone;
}

}  // namespace explore_opt
