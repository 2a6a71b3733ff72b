/// A folder of its own for a test, and the shipped configurations with changes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "quad_support/atomic_file.hpp"

/// Removed with everything in it when the test ends.
class Scratch {
 public:
  Scratch() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("quad_experiment_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Scratch() { std::filesystem::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string path(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The text of config/<name>, each {old, new} replaced once; a text that is not there fails the
/// test.
inline std::string shippedConfig(
    const std::string& name, const std::vector<std::pair<std::string, std::string>>& changes = {}) {
  std::string text = quad_support::readFile("config/" + name);  // tests run in the package's folder
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << name << " has no '" << from << "'";
    if (at != std::string::npos) text.replace(at, from.size(), to);
  }
  return text;
}
