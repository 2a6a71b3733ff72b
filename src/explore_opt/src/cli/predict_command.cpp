#include <memory>

#include "commands.hpp"
#include "explore_opt/design_json.hpp"
#include "explore_opt/signal_response.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt {
namespace {

constexpr const char* kHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt design problem.json --out design.json
  explore_opt predict problem.json design.json --out prediction.csv
  explore_opt identify prediction.csv --states x1,x2 --inputs u1 --gamma-w 20 --D 99.999
A table k,x1,...,u1,... of the nominal system without noise: T+1 rows, the last one without inputs. u is what the plant
gets, feedback K included. The design may be the answer of `design` or its amplitudes alone.
Exit code 0: done; 2: bad input.)";

struct Settings {
  std::string problem, design, out;
};

std::string toCsv(const NominalExperiment& run) {
  std::string text = "k";
  for (Eigen::Index i = 1; i <= run.X.rows(); ++i) text += ",x" + std::to_string(i);
  for (Eigen::Index j = 1; j <= run.U.rows(); ++j) text += ",u" + std::to_string(j);
  text += '\n';
  for (Eigen::Index k = 0; k < run.X.cols(); ++k) {
    text += std::to_string(k);
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
  return text;
}

int predict(const Settings& settings) {
  const ExplorationProblem problem =
      problemFromJson(quad_support::readFile(settings.problem), settings.problem);
  const Eigen::VectorXd a =
      amplitudesFromJson(quad_support::readFile(settings.design), settings.design, problem);
  const Eigen::MatrixXd table =
      a.reshaped<Eigen::RowMajor>(a.size() / problem.numInputs(), problem.numInputs());
  writeAnswer(settings.out,
              toCsv(simulateNominal(problem, multisine(problem.lines, problem.phase, table))));
  return quad_support::kDone;
}

}  // namespace

Action addPredictCommand(CLI::App& app) {
  const auto settings = std::make_shared<Settings>();
  CLI::App* command =
      app.add_subcommand("predict", "Noise-free response of the nominal system to a design");
  command->footer(kHelp);
  command->add_option("problem", settings->problem, "Problem in JSON")->required();
  command->add_option("design", settings->design, "Answer of design, or amplitudes")->required();
  command->add_option("--out", settings->out, "File for the table; default: standard output");
  return [settings] { return predict(*settings); };
}

}  // namespace explore_opt
