#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "commands.hpp"
#include "quad_experiment/ensemble.hpp"
#include "quad_experiment/table.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/program.hpp"

namespace {

using namespace quad_experiment;
using Json = nlohmann::ordered_json;

/// The run's own number behind a reference's key, from its summary.json.
double ownValue(const Json& summary, const std::string& key) {
  const auto dot = key.find('.');
  const Json& part = summary.at(key.substr(0, dot));
  const std::string name = key.substr(dot + 1);
  if (part.is_null()) return std::nan("");
  const auto entry = [&](const char* matrix, int row, int column) {
    return part.at(matrix).is_null() ? std::nan("")
                                     : part.at(matrix).at(row).at(column).get<double>();
  };
  if (name == "A21") return entry("A", 1, 0);
  if (name == "B1") return entry("B", 0, 0);
  if (name == "B2") return entry("B", 1, 0);
  const Json& value = part.at(name);
  return value.is_null() ? std::nan("") : value.get<double>();
}

/// @throws quad_support::ConfigError for a file that is not a run's summary
Json readSummary(const std::string& folder) {
  Json summary = Json::parse(quad_support::readFile(folder + "/summary.json"), nullptr, false);
  if (summary.is_discarded())
    throw quad_support::ConfigError(folder + "/summary.json: not valid JSON");
  for (const char* part : {"mode", "initial", "design", "targeted", "random"}) {
    if (!summary.contains(part))
      throw quad_support::ConfigError(
          fmt::format("{}/summary.json: has no '{}'; not a run's summary", folder, part));
  }
  return summary;
}

/// What the file and the terminal get, filled side by side.
struct Ranking {
  Json json;
  std::string text;
};

/// The run's own value of one reference among those of the seeds, `sorted`.
void addRank(const Reference& r, double own, const std::vector<double>& sorted, Ranking& out) {
  const double median = quantile(sorted, 0.5), low = quantile(sorted, 0.05),
               high = quantile(sorted, 0.95);
  const double rank = std::isfinite(own) ? percentileOf(sorted, own) : std::nan("");
  const auto orNull = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  out.json["values"][r.key] = {{"this_run", orNull(own)},
                               {"percentile", orNull(rank)},
                               {"count", sorted.size()},
                               {"median", median},
                               {"p05", low},
                               {"p95", high}};
  out.text += fmt::format("{:<28} {:>10} {:>11.5g} {:>11.1f}  {:>24}\n", r.label, r.printed, own,
                          rank, fmt::format("{:.4g} [{:.4g}, {:.4g}]", median, low, high));
}

/// How often the random signal's data contradict γ_w.
void addFalsifications(const std::vector<double>& random_G, Ranking& out) {
  if (random_G.empty()) return;
  const auto count =
      std::count_if(random_G.begin(), random_G.end(), [](double G) { return G < 0.0; });
  const double part = static_cast<double>(count) / static_cast<double>(random_G.size());
  out.json["random_falsifies_gamma_w"] = part;
  out.text +=
      fmt::format("the random signal falsifies gamma_w in {:.0f} % of the seeds\n", 100.0 * part);
}

}  // namespace

int percentiles(const PercentilesOptions& options) {
  const Json summary = readSummary(options.results);
  if (summary.at("mode") == "wallclock") {
    std::puts("a wall-clock run has no seeds to be compared with");
    return quad_support::kDone;
  }
  const ExperimentPlan plan =
      planExperiment(readExperimentConfig(options.results + "/config.yaml"));
  const int workers =
      options.workers > 0 ? options.workers : std::max(1u, std::thread::hardware_concurrency());
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const auto runs = flySeeds(plan, 1, options.seeds, workers, [&](int done) {
    if (terminal && done % 10 == 0) std::fprintf(stderr, "\r%d of %d seeds", done, options.seeds);
  });
  if (terminal) std::fprintf(stderr, "\r\033[K");

  Ranking out;
  out.json["seeds"] = options.seeds;
  out.text = fmt::format(
      "this run (seed {}) among {} flights in process, seeds 1 to {}\n{:<28} {:>10} {:>11} {:>11}  "
      "{:>24}\n",
      plan.config.seed, options.seeds, options.seeds, "", "thesis", "this run", "percentile",
      "median [5 %, 95 %]");
  for (const Reference& r : thesisReferences()) {
    const auto sorted = sortedValues(runs, r.key);
    const bool flown = r.key.rfind("targeted.", 0) == 0 || r.key.rfind("random.", 0) == 0;
    if (flown && !sorted.empty()) addRank(r, ownValue(summary, r.key), sorted, out);
  }
  addFalsifications(sortedValues(runs, "random.G"), out);
  quad_support::writeFileAtomically(options.results + "/percentiles.json", out.json.dump(2) + "\n");
  quad_support::print(out.text, "the results stand in " + options.results + "/percentiles.json");
  return quad_support::kDone;
}
