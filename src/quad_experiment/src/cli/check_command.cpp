
#include "commands.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/in_process_plant.hpp"
#include "quad_support/errors.hpp"

using namespace quad_experiment;

int check(const CheckOptions& options) {
  const ExperimentConfig config = readExperimentConfig(options.config, options.mode);
  tellNotes(config);
  InProcessPlant plant(config);  // rotors, inertia, allocation, options
  return quad_support::kDone;
}
