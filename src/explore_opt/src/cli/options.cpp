#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using Action = std::function<int()>;
using Actions = std::map<std::string, Action>;

/// A subcommand, its settings, and what to do if it is the one.
template <typename Settings>
class Command {
 public:
  Command(CLI::App& app, Actions& actions, const std::string& name, const std::string& what,
          const char* help, int (*run)(const Settings&))
      : settings_(std::make_shared<Settings>()), command_(app.add_subcommand(name, what)) {
    command_->footer(help);
    actions[name] = [settings = settings_, run] { return run(*settings); };
  }
  Settings& settings() { return *settings_; }
  CLI::App* operator->() { return command_; }

  void problem() {
    command_->add_option("problem", settings_->problem, "Problem in JSON")->required();
  }
  void design(const char* what) {
    problem();
    command_->add_option("design", settings_->design, what)->required();
  }
  void out() {
    command_->add_option("--out", settings_->out, "File for the answer; default: standard output");
  }

 private:
  std::shared_ptr<Settings> settings_;
  CLI::App* command_;
};

void addFrequencies(CLI::App& app, Actions& actions) {
  Command<FrequenciesSettings> c(
      app, actions, "frequencies",
      "Lines for a design, by the frequency response; data of its picture", kFrequenciesHelp,
      runFrequencies);
  FrequenciesSettings& s = c.settings();
  c->add_option("system", s.system, "Problem in JSON, with or without lines")->required();
  c->add_option("--lines", s.options.lines, "How many; default: n_x + n_u");
  c->add_option("--band", s.band, "LOW HIGH [cycles per sample]; default: all")->expected(2);
  c->add_option("--problem", s.problem,
                "File for the problem with the lines chosen, ready for design");
  c.out();
}

void addDesign(CLI::App& app, Actions& actions) {
  Command<DesignSettings> c(app, actions, "design",
                            "Amplitudes of least norm that guarantee the desired closeness",
                            kDesignHelp, runDesign);
  DesignSettings& s = c.settings();
  DesignOptions& options = s.options;
  c.problem();
  c->add_option("--method", s.method, "global: certified; mm: the paper's algorithm")
      ->capture_default_str()
      ->check(CLI::IsMember({"global", "mm"}));
  c.out();
  c->add_option("--dump", s.dump, "File for problem, options and answer; see replay");
  c->add_option("--seed", options.seed, "Of random starts")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  c->add_option("--starts", options.random_starts,
                "global: random starts while the gap is open; at most 10000")
      ->capture_default_str();
  c->add_option("--initial", s.initial,
                "mm: JSON file with the candidate to start at; default: ones, or a search");
  c->add_option("--max-iterations", options.max_iterations, "mm: re-linearisations")
      ->capture_default_str();
  c->add_option("--cost-tolerance", options.cost_tolerance,
                "mm: relative change of gamma_e to stop at")
      ->capture_default_str();
  c->add_option("--step-tolerance", options.step_tolerance,
                "mm: relative change of amplitudes to stop at")
      ->capture_default_str();
  c->add_flag("--plain", s.plain, "mm: without lengthening steps, as in the paper");
}

void addAudit(CLI::App& app, Actions& actions) {
  Command<AuditSettings> c(app, actions, "audit",
                           "Recomputes what a design claims, independently of the solvers",
                           kAuditHelp, runAudit);
  c.design("Answer of design");
  c.out();
}

void addBaselines(CLI::App& app, Actions& actions) {
  Command<BaselinesSettings> c(
      app, actions, "baselines",
      "What noise, PRBS, chirp, multisines and classical designs must cost instead", kBaselinesHelp,
      runBaselines);
  BaselinesSettings& s = c.settings();
  c.problem();
  c.out();
  c->add_option("--seeds", s.options.seeds, "Draws of each random signal")->capture_default_str();
  c->add_option("--seed", s.options.seed, "Of the random signals and starts")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  c->add_option("--band", s.band,
                "LOW HIGH [cycles per sample] of band_limited and chirp; default: from the lowest "
                "line to the highest")
      ->expected(2);
}

void addPredict(CLI::App& app, Actions& actions) {
  Command<PredictSettings> c(app, actions, "predict",
                             "Noise-free response of the nominal system to a design", kPredictHelp,
                             runPredict);
  c.design("Answer of design, or amplitudes");
  c->add_option("--run", c.settings().run,
                "Only this one of several experiments, from 1; default: all, with a column `run`");
  c.out();
}

void addIdentify(CLI::App& app, Actions& actions) {
  Command<IdentifySettings> c(app, actions, "identify",
                              "Least squares and the set of parameters the data leave possible",
                              kIdentifyHelp, runIdentify);
  IdentifySettings& s = c.settings();
  c->add_option("data", s.data, "Tables in CSV, a row a sample, T+1 rows")->required();
  c->add_option("--states", s.states, "Columns of the states")->delimiter(',')->required();
  c->add_option("--inputs", s.inputs, "Columns of the inputs")->delimiter(',')->required();
  c->add_option("--where", s.where, "Only the rows with column=value");
  c->add_option("--gamma-w", s.gamma_w,
                "Bound on the energy of the disturbance, above 0; several files: one or one each")
      ->delimiter(',')
      ->required();
  c->add_option("--D", s.closeness,
                "Desired closeness: a number or a JSON file; default: not judged");
  c->add_option("--known", s.known,
                "JSON file with the known entries of [A B], null where unknown");
  c->add_option("--function", s.functions,
                "Whose interval is asked: 'A12/B2', 'm = 0.1/B2', '2*A12 - B1'; may be repeated")
      ->expected(1)
      ->take_all();
  c->add_option("--contains", s.candidate,
                "JSON file with an [A B]: do the data leave it possible?");
  c.out();
}

void addReplay(CLI::App& app, Actions& actions) {
  Command<ReplaySettings> c(app, actions, "replay", "Repeats a solve from its dump and compares",
                            kReplayHelp, runReplay);
  c->add_option("dump", c.settings().dump, "File of design --dump")->required();
  c.out();
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  CLI::App app("Targeted exploration of linear systems under energy-bounded disturbances",
               "explore_opt");
  app.set_version_flag("--version", quad_support::kVersion);
  app.require_subcommand(1);
  app.footer("The --help of each subcommand shows an example that runs.");
  Actions actions;
  for (const auto add :
       {addFrequencies, addDesign, addAudit, addBaselines, addPredict, addIdentify, addReplay}) {
    add(app, actions);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    throw quad_support::DataError(
        quad_support::argumentProblem("explore_opt", e.what(), commands, argc, argv));
  }
  return actions.at(app.get_subcommands().front()->get_name())();
}

}  // namespace explore_opt
