// Specs: grids, draws and their laws, complaints.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "quad_support/errors.hpp"
#include "spec_file.hpp"

using namespace quad_experiment;

namespace {

std::string valueOf(const BatchSpec& spec, std::int64_t run, const std::string& key) {
  for (const auto& setting : spec.variedSettings(run)) {
    if (setting.key == key) return setting.value;
  }
  return "";
}

std::string complaint(const std::string& rest) {
  try {
    SpecFile(rest).read();
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(BatchSpec, GridIsTraversedWithTheLastKeyFastest) {
  const BatchSpec spec = SpecFile(
                             "seed: 1\nruns: 2\nvary:\n  design.gamma_w: {grid: [4, 5]}\n  "
                             "timing.latency: {grid: [0.0, 0.01, 0.02]}\n"
                             "  seed: {count: 7, common: true}\n")
                             .read();
  EXPECT_EQ(spec.points, 6);
  EXPECT_EQ(spec.runs(), 12);
  EXPECT_EQ(valueOf(spec, 1, "design.gamma_w"), "4");
  EXPECT_EQ(valueOf(spec, 1, "timing.latency"), "0.01");
  EXPECT_EQ(valueOf(spec, 9, "design.gamma_w"), "5");
  EXPECT_EQ(valueOf(spec, 9, "timing.latency"), "0.0");
  EXPECT_EQ(valueOf(spec, 5, "seed"), "7");  // common: one seed for all points of a repeat
  EXPECT_EQ(valueOf(spec, 6, "seed"), "8");
}

TEST(BatchSpec, DrawsDependOnKeyAndRunAlone) {
  const std::string mass = "  vehicle.mass: {uniform: [0.7, 0.76]}\n";
  const BatchSpec one = SpecFile("seed: 1\nruns: 10\nvary:\n" + mass).read();
  const BatchSpec more = SpecFile(
                             "seed: 1\nruns: 20\nvary:\n  seed: {count: 1}\n  timing.jitter_std: "
                             "{uniform: [0.0, 0.01]}\n" +
                             mass)
                             .read();
  const BatchSpec other = SpecFile("seed: 2\nruns: 10\nvary:\n" + mass).read();
  std::set<std::string> seen;
  for (int run = 0; run < 10; ++run) {
    const std::string value = valueOf(one, run, "vehicle.mass");
    EXPECT_EQ(value, valueOf(more, run, "vehicle.mass"));
    EXPECT_NE(value, valueOf(other, run, "vehicle.mass"));
    EXPECT_TRUE(seen.insert(value).second);
  }
}

// Means of n draws lie within 5 standard deviations of the mean of the law, whose chance is below
// 1e-6; the draws are fixed, so this passes always or never.
TEST(BatchSpec, DrawsFollowTheirLaws) {
  const BatchSpec spec =
      SpecFile(
          "seed: 3\nruns: 4000\nvary:\n  vehicle.mass: {normal: [0.73, 0.02], min: 0.72}\n"
          "  design.gamma_w: {log_uniform: [1, 100]}\n  control.hold_time: {uniform: [1, 3]}\n"
          "  seed: {integer: [3, 5]}\n  control.altitude[1]: {choice: [0.5, 0.7]}\n")
          .read();
  constexpr int kDraws = 4000;
  double mass = 0, log_gamma = 0, hold = 0;
  std::map<std::string, int> seeds, gains;
  for (int run = 0; run < kDraws; ++run) {
    const double m = std::stod(valueOf(spec, run, "vehicle.mass"));
    EXPECT_GE(m, 0.72);
    mass += m / kDraws;
    log_gamma += std::log10(std::stod(valueOf(spec, run, "design.gamma_w"))) / kDraws;
    hold += std::stod(valueOf(spec, run, "control.hold_time")) / kDraws;
    ++seeds[valueOf(spec, run, "seed")];
    ++gains[valueOf(spec, run, "control.altitude[1]")];
  }
  const double n = std::sqrt(kDraws);
  EXPECT_NEAR(mass, 0.73 + 0.02 * 0.509160,
              5 * 0.02 / n);  // truncated at -0.5 sigma: phi/Phi = 0.50916
  EXPECT_NEAR(log_gamma, 1.0, 5 * 0.5774 / n);
  EXPECT_NEAR(hold, 2.0, 5 * 0.5774 / n);
  ASSERT_EQ(seeds.size(), 3u);
  for (const auto& [seed, count] : seeds) EXPECT_NEAR(count, kDraws / 3.0, 5 * 0.4714 * n) << seed;
  EXPECT_NEAR(gains["0.5"], kDraws / 2.0, 5 * 0.5 * n);
}

TEST(BatchSpec, ComplaintsNameTheKey) {
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  design.gamma: {grid: [1]}\n")
                .find("design.gamma is not a key of this program"),
            std::string::npos);
  const std::string misspelt = complaint("seed: 1\nruns: 1\nvary:\n  vehicle.mas: {grid: [1]}\n");
  EXPECT_NE(misspelt.find("spec.yaml:5: vary.vehicle.mas"), std::string::npos) << misspelt;
  EXPECT_NE(misspelt.find("did you mean mass?"), std::string::npos) << misspelt;
  EXPECT_NE(complaint("seed: 1\nruns: 0\nvary: {}\n")
                .find("spec.yaml:3: runs = 0; must be a whole number in 1.."),
            std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  seed: 4\n")
                .find("spec.yaml:5: vary.seed = 4; must say how it varies"),
            std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  seed: {gamma: [1, 2]}\n")
                .find("vary.seed.gamma is not a key"),
            std::string::npos);
  EXPECT_NE(
      complaint("seed: 1\nruns: 1\nvary:\n  vehicle.mass: {uniform: [2, 1]}\n").find("low <= high"),
      std::string::npos);
  EXPECT_NE(complaint("seed: 1\nruns: 1\nvary:\n  vehicle.mass: {uniform: [1, 2], grid: [1]}\n")
                .find("stands beside"),
            std::string::npos);
  const std::string negative = complaint("seed: 1\nruns: 1\nset: {design.gamma_w: -1}\nvary: {}\n");
  EXPECT_NE(negative.find("spec.yaml:4: set.design.gamma_w = -1; run 0: "), std::string::npos)
      << negative;
  EXPECT_NE(negative.find("design.gamma_w = -1; must be > 0"), std::string::npos) << negative;
}
