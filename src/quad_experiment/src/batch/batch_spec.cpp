#include "quad_experiment/batch_spec.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <set>

#include "quad_experiment/streams.hpp"
#include "quad_experiment/version.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/command_line.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "quad_support/random_stream.hpp"
#include "quad_support/sha256.hpp"

namespace quad_experiment {
namespace {

using quad_support::ConfigReader;
using quad_support::Override;
using quad_support::Range;
using VariationKind = Variation::Kind;

constexpr std::int64_t kMaxRuns = 1000000000;
constexpr std::int64_t kMaxInteger = 9007199254740992;  // 2^53: exact as a double
constexpr int kMaxRedraws = 10000;  // of a normal; one in a thousand inside is as good as certain

const std::vector<std::pair<std::string, VariationKind>>& kinds() {
  static const std::vector<std::pair<std::string, VariationKind>> all = {
      {"grid", VariationKind::kGrid},       {"choice", VariationKind::kChoice},
      {"uniform", VariationKind::kUniform}, {"log_uniform", VariationKind::kLogUniform},
      {"normal", VariationKind::kNormal},   {"integer", VariationKind::kInteger},
      {"count", VariationKind::kCount}};
  return all;
}

void readEnds(const ConfigReader& in, const std::string& name, const Range& range, Variation& v) {
  const auto ends = in.numbers(name, range, 2);
  v.a = ends[0];
  v.b = ends[1];
  if (v.a > v.b) in.fail(name, "must be [low, high] with low <= high");
}

void readNumbers(const ConfigReader& in, const std::string& name, Variation& v) {
  switch (v.kind) {
    case VariationKind::kGrid:
    case VariationKind::kChoice:
      v.values = in.values(name);
      break;
    case VariationKind::kUniform:
      readEnds(in, name, Range::any(), v);
      break;
    case VariationKind::kLogUniform:
      readEnds(in, name, Range::positive(), v);
      break;
    case VariationKind::kInteger: {
      const auto ends = in.integers(name, -kMaxInteger, kMaxInteger);
      if (ends.size() != 2 || ends[0] > ends[1] || ends[1] - ends[0] >= kMaxInteger)
        in.fail(name, "must be [low, high], whole numbers with low <= high");
      v.a = static_cast<double>(ends[0]);
      v.b = static_cast<double>(ends[1]);
      break;
    }
    case VariationKind::kNormal: {
      const auto moments = in.numbers(name, Range::any(), 2);
      v.a = moments[0];
      v.b = moments[1];
      if (!(v.b > 0.0)) in.fail(name, "must be [mean, standard deviation], the deviation > 0");
      v.min = in.has("min") ? in.number("min", Range::any()) : -HUGE_VAL;
      v.max = in.has("max") ? in.number("max", Range::any()) : HUGE_VAL;
      break;
    }
    case VariationKind::kCount:
      v.a = static_cast<double>(in.integer(name, 0, kMaxInteger - kMaxRuns));
      break;
  }
}

Variation readVariation(const ConfigReader& in, const std::string& key) {
  if (!in.isSection(key))
    in.fail(key,
            "must say how it varies, for instance {uniform: [0.7, 0.76]}; a value for all "
            "runs belongs into `set`");
  const ConfigReader how = in.section(key);
  Variation v;
  v.key = key;
  std::string name;
  for (const auto& [word, kind] : kinds()) {
    if (!how.has(word)) continue;
    if (!name.empty()) how.fail(word, "stands beside " + name + "; give one of them");
    name = word;
    v.kind = kind;
  }
  if (name.empty()) {
    how.finish();  // a word that is none of them; else the map is empty
    in.fail(key, "must hold one of: grid, choice, uniform, log_uniform, normal, integer, count");
  }
  readNumbers(how, name, v);
  if (v.kind != VariationKind::kGrid && how.has("common")) v.common = how.boolean("common");
  how.finish();
  return v;
}

/// One number in (0, 1) for each key, run and attempt, whatever else varies.
std::uint64_t streamOf(const std::string& key) {
  return kVaryStreams | (std::stoull(quad_support::sha256(key).substr(0, 15), nullptr, 16));
}

double drawNormal(const Variation& v, const quad_support::RandomStream& random) {
  for (int attempt = 0; attempt < kMaxRedraws; ++attempt) {
    const double x = v.a + v.b * random.normal(static_cast<std::uint64_t>(attempt));
    if (x >= v.min && x <= v.max) return x;
  }
  throw quad_support::ConfigError(
      fmt::format("vary.{}: no draw of {} lies between min and max", v.key, kMaxRedraws));
}

std::string draw(const Variation& v, std::uint64_t seed, std::int64_t index) {
  const quad_support::RandomStream random(seed, static_cast<std::uint64_t>(index), streamOf(v.key));
  switch (v.kind) {
    case VariationKind::kChoice: {
      const auto count = static_cast<double>(v.values.size());
      return v.values[static_cast<std::size_t>(std::min(random.uniform(0) * count, count - 1.0))];
    }
    case VariationKind::kUniform:
      return quad_support::shortest(v.a + (v.b - v.a) * random.uniform(0));
    case VariationKind::kLogUniform:
      return quad_support::shortest(v.a * std::pow(v.b / v.a, random.uniform(0)));
    case VariationKind::kNormal:
      return quad_support::shortest(drawNormal(v, random));
    case VariationKind::kInteger:
      return fmt::format("{}", static_cast<std::int64_t>(std::min(
                                   std::floor(v.a + (v.b - v.a + 1.0) * random.uniform(0)), v.b)));
    case VariationKind::kCount:
      return fmt::format("{}", static_cast<std::int64_t>(v.a) + index);
    case VariationKind::kGrid:
      break;
  }
  return {};
}

std::vector<Override> readSet(const ConfigReader& in) {
  std::vector<Override> set;
  for (const std::string& key : in.keys()) set.push_back({key, in.value(key)});
  in.finish();
  return set;
}

/// Every model a run may load, by content.
std::string modelHashes(const BatchSpec& spec, const ExperimentConfig& first) {
  std::string text = quad_support::sha256(quad_support::readFile(first.simulation.urdf));
  for (const Variation& v : spec.vary) {
    if (v.key != "vehicle.urdf") continue;
    const std::string folder =
        ConfigReader::fromText(spec.base_text, spec.base_path).resolvePath(".");
    for (const std::string& name : v.values) {
      const std::string path = quad_sim::findUrdf(name, folder);
      text += path.empty() ? name : quad_support::sha256(quad_support::readFile(path));
    }
  }
  return text;
}

/// Whether a complaint is about this key, not about one whose name it begins or ends.
bool names(const std::string& complaint, const std::string& key) {
  const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t at = complaint.find(key); at != std::string::npos;
       at = complaint.find(key, at + 1)) {
    const std::size_t end = at + key.size();
    const bool starts = at == 0 || !(part(complaint[at - 1]) || complaint[at - 1] == '.');
    if (starts && (end == complaint.size() || !part(complaint[end]))) return true;
  }
  return false;
}

/// Run 0, whose complaints are most often about all runs: those about a key that varies or is set
/// name the spec's line, not the base's.
ExperimentConfig requireFirstRun(const BatchSpec& spec, const ConfigReader& in) {
  try {
    return spec.experiment(0);
  } catch (const std::invalid_argument& e) {
    const std::string complaint = fmt::format("run 0: {}", e.what());
    for (const Variation& v : spec.vary) {
      if (names(complaint, v.key)) in.section("vary").fail(v.key, complaint);
    }
    for (const Override& o : spec.set) {
      if (names(complaint, o.key)) in.section("set").fail(o.key, complaint);
    }
    throw quad_support::ConfigError(fmt::format("{}: {}", spec.path, complaint));
  }
}

}  // namespace

std::vector<Override> BatchSpec::variedSettings(std::int64_t run) const {
  std::vector<Override> settings(vary.size());
  std::int64_t point = run % points;
  for (std::size_t i = vary.size(); i-- > 0;) {
    const Variation& v = vary[i];
    settings[i].key = v.key;
    if (v.kind == VariationKind::kGrid) {
      const auto count = static_cast<std::int64_t>(v.values.size());
      settings[i].value = v.values[static_cast<std::size_t>(point % count)];
      point /= count;
    } else {
      settings[i].value = draw(v, seed, v.common ? run / points : run);
    }
  }
  return settings;
}

ExperimentConfig BatchSpec::experiment(std::int64_t run) const {
  std::vector<Override> overrides = set;
  for (Override& o : variedSettings(run)) overrides.push_back(std::move(o));
  return readExperimentConfig(ConfigReader::fromText(base_text, base_path, overrides), "lockstep");
}

BatchSpec readBatchSpec(const std::string& path, std::int64_t repeats) {
  const ConfigReader in = ConfigReader::fromFile(path);
  BatchSpec spec;
  spec.path = path;
  spec.base_path = in.resolvePath(in.text("base"));
  try {
    spec.base_text = quad_support::readFile(spec.base_path);
  } catch (const std::invalid_argument& e) {
    in.fail("base", e.what());
  }
  spec.seed = static_cast<std::uint64_t>(in.integer("seed", 0, kMaxInteger));
  spec.repeats = in.integer("runs", 1, kMaxRuns);
  if (repeats > 0) spec.repeats = repeats;
  if (in.has("set")) spec.set = readSet(in.section("set"));
  const ConfigReader vary = in.section("vary");
  for (const std::string& key : vary.keys()) {
    spec.vary.push_back(readVariation(vary, key));
    if (spec.vary.back().kind == VariationKind::kGrid)
      spec.points *= static_cast<std::int64_t>(spec.vary.back().values.size());
    if (spec.points > kMaxRuns) in.fail("vary", "spans a grid of more than 1e9 points");
  }
  if (spec.repeats > kMaxRuns / spec.points)
    in.fail("runs", fmt::format("times {} points of the grid is more than 1e9 runs", spec.points));
  in.finish();
  const ExperimentConfig first = requireFirstRun(spec, in);
  spec.hash = quad_support::sha256(
      fmt::format("{}\n{}\n{}\n{}\n{} {}", quad_support::sha256(quad_support::readFile(path)),
                  quad_support::sha256(spec.base_text), modelHashes(spec, first), spec.repeats,
                  quad_support::kVersion, gitState()));
  return spec;
}

}  // namespace quad_experiment
