#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "quad_experiment/comparison.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

using namespace quad_experiment;

int compare(const CompareOptions& options) {
  const ExperimentConfig config = readExperimentConfig(options.config, "lockstep");
  quad_support::ResultDirectory results(options.out, options.force);
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const Comparison comparison = compareSignals(config, options.seeds, [&](int done, int total) {
    if (terminal && done % 10 == 0) std::fprintf(stderr, "\r%d of %d flights", done, total);
  });
  if (terminal) std::fputs("\r\033[K", stderr);
  const std::string text = comparisonText(comparison);
  results.write("config.yaml", toYaml(config));
  results.write("comparison.json", comparisonJson(config, comparison).dump(2) + "\n");
  results.write("comparison.csv", comparisonCsv(comparison));
  results.write("comparison.txt", text);
  results.commit();
  tellResults(text, results.path());
  return quad_support::kDone;
}
