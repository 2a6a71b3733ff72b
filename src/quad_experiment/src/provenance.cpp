#include <fmt/core.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "explore_opt/exploration_signal.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_experiment/version.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/number_format.hpp"
#include "quad_support/sha256.hpp"

namespace quad_experiment {
namespace {

std::string hashOf(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    quad_support::appendShortest(text, value);
    text += '\n';
  }
  return quad_support::sha256(text);
}

}  // namespace

nlohmann::ordered_json provenanceJson(const ExperimentPlan& plan, const std::string& mode) {
  nlohmann::ordered_json j;
  j["mode"] = mode;
  j["deterministic"] = mode != "wallclock";
  j["seed"] = plan.config.seed;
  j["gamma_w"] = plan.config.design.gamma_w;
  j["inputs_sha256"] = {
      {"config", configHash(plan.config)},
      {"urdf", quad_support::sha256(quad_support::readFile(plan.config.simulation.urdf))},
      {"design_amplitudes",
       hashOf({plan.design.amplitudes.data(),
               plan.design.amplitudes.data() + plan.design.amplitudes.size()})},
      {"targeted_signal", hashOf(plan.targeted_signal)},
      {"random_signal", plan.gaussian_signal.empty()
                            ? nlohmann::ordered_json(nullptr)
                            : nlohmann::ordered_json(hashOf(plan.gaussian_signal))}};
  j["versions"] = {{"quad_experiment", quad_support::kVersion},
                   {"git", gitState()},
                   {"compiler", kCompiler},
                   {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                         EIGEN_MINOR_VERSION)},
                   {"ode", kOdeVersion},
                   {"ipopt", kIpoptVersion}};
  const std::vector<std::string> told = notes(plan.config);
  if (!told.empty()) j["notes"] = told;
  return j;
}

}  // namespace quad_experiment
