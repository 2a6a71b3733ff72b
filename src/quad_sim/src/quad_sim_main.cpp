// The program quad_sim: simulate.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "quad_sim/plugin.hpp"
#include "quad_sim/replay.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "quad_support/program.hpp"

namespace {

using quad_support::shortest;

struct SimulateArguments {
  std::string urdf, commands, state, out;
  std::string mode = "folded", profile = "default", ground = "off";
  double step = 0.001, duration = 0, gravity = 9.8;
  std::vector<std::string> quirks;
  std::uint64_t seed = 0;
  std::int64_t every = 1;
  bool verbose = false;
};

constexpr const char* kExample = R"(Example (from the workspace, after `make build`):
  printf 't,w0,w1,w2,w3\n0,460,460,460,460\n' > /tmp/cmds.csv
  build/devel/lib/quad_sim/quad_sim simulate --urdf build/urdf/hummingbird.urdf --commands /tmp/cmds.csv \
    --duration 5 --every 100 --out /tmp/states.csv
Exit codes: 0 done, 2 bad input, 4 diverged, 5 the output cannot be written.)";

void addSimulate(CLI::App& app, SimulateArguments& a) {
  CLI::App* simulate =
      app.add_subcommand("simulate", "Replay rotor-speed commands open loop and write the states.");
  simulate->footer(kExample);
  simulate->add_option("--urdf", a.urdf, "plain URDF of the vehicle")->required();
  simulate
      ->add_option("--commands", a.commands,
                   "CSV t,w0,w1,... [s, rad/s]: a row is held until the next and acts from the "
                   "first physics step that "
                   "starts at or after its t; zero before the first")
      ->required();
  simulate
      ->add_option("--out", a.out,
                   "CSV to write: t, position and velocity of base_link in world axes, quaternion, "
                   "body rates, rotor "
                   "speeds")
      ->required();
  simulate->add_option("--duration", a.duration, "[s], a whole number of steps")->required();
  simulate->add_option("--step", a.step, "physics step [s]")->capture_default_str();
  simulate->add_option("--state", a.state,
                       "CSV of one row, the output's columns without t: the start; "
                       "default (0, 0, 0.06) at rest, rotors still");
  simulate
      ->add_option("--every", a.every,
                   "physics steps between rows; the last state is always written")
      ->capture_default_str();
  simulate->add_option("--gravity", a.gravity, "[m/s^2]")->capture_default_str();
  simulate->add_option("--ground", a.ground, "contact plane at z = 0: on or off")
      ->capture_default_str();
  simulate->add_option("--mode", a.mode, "folded or hinged")->capture_default_str();
  simulate->add_option("--profile", a.profile, "default or rotors_compat")->capture_default_str();
  simulate
      ->add_option("--quirks", a.quirks,
                   "of RotorS, to add to the default profile one by one: " +
                       fmt::format("{}", fmt::join(quad_sim::RotorsQuirks::names(), ", ")))
      ->delimiter(',');
  simulate->add_option("--seed", a.seed, "of turbulence and of sensors' noise")
      ->capture_default_str();
  simulate->add_flag("--verbose", a.verbose,
                     "also list the URDF's plugins that have no effect here");
}

/// Which of two words an option says.
bool isSecond(const std::string& option, const std::string& value, const std::string& first,
              const std::string& second) {
  if (value != first && value != second) {
    throw std::invalid_argument(
        fmt::format("{} {}; must be {} or {}", option, value, first, second));
  }
  return value == second;
}

std::int64_t countSteps(const SimulateArguments& a, std::int64_t step_ns) {
  constexpr double kLongest = 1e6;  // [s]
  if (!(a.duration >= 0) || a.duration > kLongest) {
    throw std::invalid_argument(
        fmt::format("--duration {}; must lie in [0, {}] s", shortest(a.duration), kLongest));
  }
  const std::int64_t duration_ns = std::llround(a.duration * 1e9);
  if (duration_ns % step_ns != 0) {
    throw std::invalid_argument(
        fmt::format("--duration {} s; must be a whole number of steps of {} s",
                    shortest(a.duration), shortest(a.step)));
  }
  return duration_ns / step_ns;
}

/// The simulator, whose complaints about an option name the key of a configuration, in the words of
/// the command line.
quad_sim::Simulator makeSimulator(const quad_sim::VehicleModel& model,
                                  const quad_sim::SimulatorOptions& options) {
  try {
    return quad_sim::Simulator(model, options);
  } catch (const std::invalid_argument& e) {
    const std::string text = e.what();
    for (const auto& [key, option] :
         {std::pair<std::string, std::string>{"simulation.step = ", "--step "},
          {"simulation.gravity = ", "--gravity "},
          {"simulation.multibody = ", "--mode "},
          {"simulation.profile = ", "--profile "}}) {
      if (text.rfind(key, 0) == 0) throw std::invalid_argument(option + text.substr(key.size()));
    }
    throw;
  }
}

/// Starts from the state in the file, whose contents are complained about with its name.
void startFrom(const std::string& file, quad_sim::Simulator& simulator) {
  const auto table = quad_support::CsvTable::read(file);
  const quad_sim::VehicleState start = quad_sim::readState(table, simulator.model().rotors.size());
  try {
    simulator.setStartState(start);
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument(table.place(0) + ": " + e.what());
  }
}

int simulate(const SimulateArguments& a) {
  quad_sim::SimulatorOptions options;
  options.step = a.step;
  options.gravity = a.gravity;
  options.ground = isSecond("--ground", a.ground, "off", "on");
  options.multibody = isSecond("--mode", a.mode, "folded", "hinged") ? quad_sim::Multibody::kHinged
                                                                     : quad_sim::Multibody::kFolded;
  options.profile = isSecond("--profile", a.profile, "default", "rotors_compat")
                        ? quad_sim::Profile::kRotorsCompat
                        : quad_sim::Profile::kDefault;
  for (const std::string& name : a.quirks) {
    try {
      options.quirks.byName(name) = true;
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string("--quirks ") + e.what());
    }
  }
  options.seed = a.seed;
  if (a.every < 1) throw std::invalid_argument(fmt::format("--every {}; must be >= 1", a.every));

  const quad_sim::VehicleModel model = quad_sim::loadVehicle(a.urdf);
  const std::size_t rotors = model.rotors.size();
  for (const std::string& note : model.notes)
    std::fprintf(stderr, "quad_sim: note: %s\n", note.c_str());
  if (a.verbose) {
    for (const std::string& plugin : quad_sim::ignoredPlugins(model)) {
      std::fprintf(stderr, "quad_sim: note: without effect here: %s\n", plugin.c_str());
    }
  }
  const auto commands = quad_sim::readCommands(quad_support::CsvTable::read(a.commands), rotors);
  quad_sim::Simulator simulator = makeSimulator(model, options);
  const std::int64_t steps = countSteps(a, simulator.stepNanoseconds());
  if (a.state.empty()) {
    quad_sim::VehicleState start;
    start.p_WB.z() = 0.06;  // where the Hummingbird rests on the ground
    start.rotor_speed.assign(rotors, 0.0);
    simulator.setStartState(start);
  } else {
    startFrom(a.state, simulator);
  }
  quad_support::writeFileAtomically(a.out, quad_sim::replay(simulator, commands, steps, a.every));
  if (simulator.commandCounts().clamped > 0) {
    std::fprintf(stderr, "quad_sim: note: %lld commands were clamped to [0, max speed]\n",
                 static_cast<long long>(simulator.commandCounts().clamped));
  }
  return quad_support::kDone;
}

int run(int argc, char** argv) {
  CLI::App app("quad_sim: the plant of the exploration experiments, without ROS.");
  app.set_version_flag("--version", quad_support::kVersion);
  app.require_subcommand(1);
  app.footer(kExample);
  SimulateArguments arguments;
  addSimulate(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {  // --help, --version
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    throw std::invalid_argument(
        quad_support::argumentProblem("quad_sim", e.what(), {"simulate"}, argc, argv));
  }
  return simulate(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  return quad_support::runProgram("quad_sim", [&] { return run(argc, argv); });
}
