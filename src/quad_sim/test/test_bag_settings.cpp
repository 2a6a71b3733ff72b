// What a bag plugin's tags mean, and what the files are called.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "bag_settings.hpp"
#include "hummingbird.hpp"
#include "quad_support/errors.hpp"

namespace quad_sim {
namespace {

namespace fs = std::filesystem;

PluginDeclaration declaration(std::map<std::string, std::string> tags) {
  tags.emplace("linkName", "hummingbird/base_link");
  return {"librotors_gazebo_bag_plugin.so", "rosbag", "x.urdf:1", tags};
}

std::string problemOf(const std::map<std::string, std::string>& tags) {
  return complaint<quad_support::ConfigError>(
      [&] { BagSettings(declaration(tags), hummingbird()); });
}

TEST(BagSettings, DefaultsAreThoseOfRotorS) {
  const BagSettings s(declaration({}), hummingbird());
  EXPECT_EQ(s.file, "simulator.bag");
  EXPECT_EQ(s.service, "record_rosbag");
  EXPECT_EQ(s.frame, "ground_truth_pose");
  EXPECT_FALSE(s.wait);
  EXPECT_EQ(s.cycle_us, 10000);
  EXPECT_EQ(s.trajectory, "command/trajectory");
}

TEST(BagSettings, TagsAreRead) {
  const BagSettings s(
      declaration({{"windTopic", "old"}, {"updateRate", "250"}, {"waitToRecordBag", "1"}}),
      hummingbird());
  EXPECT_EQ(s.external_force, "old");
  EXPECT_EQ(s.cycle_us, 4000);
  EXPECT_TRUE(s.wait);
}

TEST(BagSettings, MistakesAreNamed) {
  EXPECT_NE(problemOf({{"linkName", "wing"}}).find("linkName = wing names no link"),
            std::string::npos);
  EXPECT_NE(problemOf({{"linkName", "hummingbird/rotor_0"}}).find("must be a link fixed to"),
            std::string::npos);
  EXPECT_NE(problemOf({{"waitToRecordBag", "later"}}).find("must be true or false"),
            std::string::npos);
  EXPECT_NE(problemOf({{"bagFileName", ""}}).find("must not be empty"), std::string::npos);
}

TEST(BagName, HasTheDateAndIsNew) {
  setenv("TZ", "UTC", 1);
  tzset();
  const fs::path folder = fs::path(testing::TempDir()) / "bag_name";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string file = (folder / "bee.bag").string();
  const std::string first = (folder / "bee_1970-01-02-00-00-01.bag").string();
  EXPECT_EQ(bagName(file, 86401), first);
  EXPECT_EQ(bagName((folder / "bee").string(), 86401), first);
  std::ofstream(first + ".active").put('x');
  EXPECT_EQ(bagName(file, 86401), (folder / "bee_1970-01-02-00-00-01_2.bag").string());
}

}  // namespace
}  // namespace quad_sim
