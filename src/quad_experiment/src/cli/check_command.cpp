#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"

namespace {

using namespace quad_experiment;

int check(const std::string& path) {
  const ExperimentConfig config = readExperimentConfig(path);
  InProcessPlant plant(config.simulation, config.control);  // rotors, inertia, allocation, options
  return quad_support::kDone;
}

}  // namespace

void addCheckCommand(CLI::App& app, Command& chosen) {
  auto config = std::make_shared<std::string>();
  auto mode = std::make_shared<std::string>();
  auto* command = app.add_subcommand("check", "Read and check settings and vehicle; fly nothing");
  command->add_option("--config", *config, "experiment settings (YAML)")->required();
  command->add_option("--mode", *mode, "timing mode the experiment will be flown in")
      ->check(CLI::IsMember({"lockstep", "wallclock"}));
  command->footer("Example:\n  quad_experiment check --config config/thesis.yaml\nExit code: 0 good, 2 bad input.");
  command->callback([config, &chosen] { chosen = [config] { return check(*config); }; });
}
