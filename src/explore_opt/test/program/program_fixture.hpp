/// Runs the built program in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "quad_support/atomic_file.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt::testing {

using nlohmann::json;
namespace fs = std::filesystem;

inline constexpr const char* kThesis =
    R"({"A": [[1, 0.1635], [0, 1]], "B": [[0.021396], [0.261726]], "T": 370,
  "harmonics": [3, 6, 8, 10], "phase": "sin", "gamma_w": 20, "D_des": 100})";

class Program : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("explore_opt_" + std::to_string(::getpid()));
    fs::create_directories(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / name) << text;
    return (dir_ / name).string();
  }
  /// Exit code; stdout and stderr are kept.
  int run(const std::string& arguments) {
    const std::string out = (dir_ / "stdout").string(), err = (dir_ / "stderr").string();
    const std::string command = "cd '" + dir_.string() + "' && " +
                                std::string(EXPLORE_OPT_PROGRAM) + " " + arguments + " >" + out +
                                " 2>" + err;
    const int status = std::system(command.c_str());
    stdout_ = quad_support::readFile(out);
    stderr_ = quad_support::readFile(err);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  json answer() const { return json::parse(stdout_); }

  fs::path dir_;
  std::string stdout_, stderr_;
};

inline json thesis() { return json::parse(kThesis); }

inline std::string with(const std::string& key, const json& value) {
  json problem = thesis();
  problem[key] = value;
  return problem.dump();
}

/// A stable system of one state with known noise, T = 40; the first and last five rows belong to
/// another phase.
inline std::string data(double noise) {
  std::ostringstream csv;
  csv << "k,phase,x,u\n";
  double x = 0.0;
  for (int k = 0; k < 51; ++k) {
    const bool explore = k >= 5 && k < 46;
    const double u = std::cos(0.7 * k) + std::sin(0.31 * k);
    csv << k << ',' << (explore ? "explore" : "hold") << ',' << quad_support::shortest(x) << ',';
    if (k != 45) csv << quad_support::shortest(u);  // the last row of the exploration has no input
    csv << '\n';
    x = 0.5 * x + 0.4 * u + noise * (k % 2 == 0 ? 1 : -1);
  }
  return csv.str();
}

}  // namespace explore_opt::testing
