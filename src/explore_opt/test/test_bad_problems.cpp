/// Bad problems given to `explore_opt design`: the exit code and the reason, one row each.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quad_support/atomic_file.hpp"

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

json thesis() {
  return json::parse(R"({"A": [[1, 0.1635], [0, 1]], "B": [[0.021396], [0.261726]], "T": 370,
    "harmonics": [3, 6, 8, 10], "phase": "sin", "gamma_w": 20, "D_des": 100})");
}

struct BadProblem {
  std::string name;
  std::string changes;  ///< a JSON object merged into the thesis's problem (null removes a key)
  int exit_code;
  std::string reason;  ///< part of the line on stderr
};

std::string manyLines(int count) {
  std::string list = "[1";
  for (int i = 2; i <= count; ++i) list += ", " + std::to_string(i);
  return list + "]";
}

const std::vector<BadProblem>& badProblems() {
  static const std::vector<BadProblem> rows = {
      {"A not square", R"({"A": [[1, 0.1635]]})", 2, "A is 1 x 2; must be 1 x 1"},
      {"A ragged", R"({"A": [[1, 0.1], [0]]})", 2, "must have 2 numbers like the first"},
      {"A empty", R"({"A": []})", 2, "A = []; must be a list of rows"},
      {"A a text", R"({"A": [["1", 0], [0, 1]]})", 2, "must hold numbers"},
      {"B too tall", R"({"B": [[1], [1], [1]]})", 2, "B is 3 x 1; must be 2 x 1"},
      {"K of the wrong shape", R"({"K": [[1, 2], [3, 4]]})", 2, "K is 2 x 2; must be 1 x 2"},
      {"x0 too long", R"({"x0": [1, 2, 3]})", 2, "x0 is 3 x 1; must be 2 x 1"},
      {"D of no shape", R"({"D_des": [[1, 0], [0, 1]]})", 2,
       "D_des is 2 x 2; must be a number, 3 x 3"},
      {"D not symmetric", R"({"D_des": [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]})", 2,
       "D_des is not symmetric"},
      {"D indefinite", R"({"D_des": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]})", 2,
       "D_des has the eigenvalue -1"},
      {"D negative", R"({"D_des": -100})", 2, "D_des has the eigenvalue -100"},
      {"D zero", R"({"D_des": 0})", 2, "it must ask for something"},
      {"gamma_w zero", R"({"gamma_w": 0})", 2, "gamma_w = 0; must be a finite number above 0"},
      {"gamma_w negative", R"({"gamma_w": -20})", 2, "gamma_w = -20"},
      {"gamma_w beyond doubles", R"({"gamma_w": 1e400})", 2,
       "problem.json: gamma_w: number overflow parsing '1e400'; must lie within"},
      {"frequency above 1/2", R"({"harmonics": null, "frequencies": [0.1, 0.7]})", 2,
       "frequencies[1] = 0.7; must lie between 0 and 1/2"},
      {"frequency negative", R"({"harmonics": null, "frequencies": [-0.1]})", 2,
       "frequencies[0] = -0.1"},
      {"sine at 0", R"({"harmonics": [0, 3, 6]})", 2, "harmonics[0] = 0; must lie in 1..184"},
      {"sine at 1/2", R"({"harmonics": [3, 185]})", 2, "harmonics[1] = 185; must lie in 1..184"},
      {"mirrored line", R"({"harmonics": [8, 362]})", 2, "362 is 8 mirrored"},
      {"one frequency twice but for rounding",
       R"({"harmonics": null, "frequencies": [0.1, 0.25, 0.10000000000000002]})", 2,
       "frequencies[0] = 0.1 and frequencies[2] = 0.10000000000000002 are the same within T = 370"},
      {"mirrored frequency", R"({"harmonics": null, "frequencies": [0.25, 0.75]})", 2,
       "0.75 is 0.25 mirrored"},
      {"line twice", R"({"harmonics": [3, 6, 3]})", 2,
       "harmonics[2] = 3 stands in the list already"},
      {"no lines", R"({"harmonics": []})", 2, "give exactly one of the two lists"},
      {"both lists", R"({"frequencies": [0.1]})", 2, "give exactly one of the two lists"},
      {"line not whole", R"({"harmonics": [3.5]})", 2, "must be a whole number"},
      {"T zero", R"({"T": 0})", 2, "T = 0"},
      {"T without harmonics", R"({"T": 2})", 2, "T = 2 samples hold no harmonic below T/2"},
      {"T absurd", R"({"T": 1000000000000})", 2, "must be a whole number, 0 to 1e9"},
      {"T too long", R"({"T": 100000000})", 2, "T = 100000000; must be at most 10000000"},
      {"too many lines", R"({"T": 20000, "harmonics": )" + manyLines(6000) + "}", 2,
       "the problem is too large"},
      {"phase unknown", R"({"phase": "tan"})", 2, "must be sin, cos or both"},
      {"cost unknown", R"({"cost": "peak"})", 2, "cost = 'peak'; must be signal or input"},
      {"key unknown", R"({"Tee": 3})", 2, "Tee is not a key"},
      {"key missing", R"({"gamma_w": null})", 2, "gamma_w is missing"},
      {"u_max zero", R"({"u_max": 0})", 2, "u_max = 0; must be a finite number above 0"},
      {"u_max for inputs there are not", R"({"u_max": [1, 2, 3]})", 2, "u_max has 3 entries"},
      {"known all", R"({"known": [[1, 0.1635, 0.021396], [0, 1, 0.261726]]})", 2,
       "known leaves nothing to learn"},
      {"known otherwise", R"({"known": [[2, null, null], [null, null, null]]})", 2,
       "known: row 1, column 1 is 2, but [A B] has 1 there"},
      {"experiments none", R"({"experiments": 0})", 2, "experiments = 0; must lie in 1..64"},
      {"too few lines", R"({"A": [[0.5]], "B": [[1, 2, 3]], "harmonics": [5, 9], "phase": "cos"})",
       3, "no amplitudes of these 2 lines excite all 4 directions at once; add lines"},
      {"one line for two inputs",
       R"({"A": [[0.5]], "B": [[1, 2]], "harmonics": [5], "phase": "cos"})", 3,
       "no amplitudes of these 1 lines excite all 3 directions at once"},
      {"T below n_phi", R"({"T": 2, "harmonics": null, "frequencies": [0.1, 0.2]})", 3,
       "T = 2 samples cannot determine 3 regressors"},
      {"not controllable", R"({"B": [[1], [0]]})", 3, "(A, B) is not controllable"},
      {"no input acts", R"({"B": [[0], [0]]})", 3, "(A, B) is not controllable"},
      {"u_max too small", R"({"u_max": 1})", 3, "u_max is too small"},
      {"growth that leaves no digits", R"({"A": [[1.1, 0.1635], [0, 1]]})", 3,
       "A is unstable: its modes grow more than 1e+13-fold within T = 370"},
      {"overflow", R"({"A": [[8, 0.1635], [0, 3]]})", 3, "Stabilise with K"},
      {"overflow with K", R"({"A": [[8, 0.1635], [0, 3]], "K": [[0, 0]]})", 3,
       "Choose a K that stabilises"},
  };
  return rows;
}

class BadProblems : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("explore_opt_bad_" + std::to_string(::getpid()));
    fs::create_directories(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }

  /// Exit code; stdout and stderr are kept.
  int design(const std::string& problem) {
    const std::string file = (dir_ / "problem.json").string(), out = (dir_ / "out").string(),
                      err = (dir_ / "err").string();
    std::ofstream(file) << problem;
    const int status = std::system(
        (std::string(EXPLORE_OPT_PROGRAM) + " design '" + file + "' >'" + out + "' 2>'" + err + "'")
            .c_str());
    stdout_ = quad_support::readFile(out);
    stderr_ = quad_support::readFile(err);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path dir_;
  std::string stdout_, stderr_;
};

}  // namespace

TEST_F(BadProblems, EndWithTheReason) {
  for (const BadProblem& bad : badProblems()) {
    SCOPED_TRACE(bad.name);
    std::string text = bad.changes;
    if (bad.changes.find("1e400") == std::string::npos) {  // no double: no parser takes it
      json problem = thesis();
      problem.merge_patch(json::parse(bad.changes));
      text = problem.dump();
    }
    EXPECT_EQ(design(text), bad.exit_code) << stderr_;
    EXPECT_NE(stderr_.find(bad.reason), std::string::npos) << stderr_;
    EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), 1) << stderr_;  // one line
    if (bad.exit_code == 2) {
      EXPECT_EQ(stdout_, "");
      EXPECT_NE(stderr_.find("problem.json"), std::string::npos) << stderr_;
      continue;
    }
    const json answer = json::parse(stdout_);  // written on exit 3 as well
    EXPECT_NE(answer["status"], "solved");
    EXPECT_TRUE(answer["amplitudes"].is_null());
    EXPECT_TRUE(answer["gamma_e"].is_null());
  }
}

TEST_F(BadProblems, NumbersBeyondDoublesMayHaveNoKey) {
  EXPECT_EQ(design("[1e400]"), 2);
  EXPECT_NE(stderr_.find("problem.json: number overflow parsing '1e400'; must lie within"),
            std::string::npos)
      << stderr_;
}

TEST_F(BadProblems, TruncatedAnywhere) {
  const std::string whole = thesis().dump();
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    EXPECT_EQ(design(whole.substr(0, length)), 2) << whole.substr(0, length);
    EXPECT_EQ(stdout_, "");
  }
  EXPECT_EQ(design(R"({"A": [[NaN, 0], [0, 1]]})"), 2);
  EXPECT_EQ(design(R"({"A": [[null, 0], [0, 1]]})"), 2);
  EXPECT_EQ(design("[]"), 2);
}
