/// The built program and the JSON it reads and writes.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "explore_opt/design_json.hpp"
#include "explore_opt/exploration_signal.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr const char* kThesis =
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

json thesis() { return json::parse(kThesis); }

/// A stable system of one state with known noise, T = 40; the first and last five rows belong to
/// another phase.
std::string data(double noise) {
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

std::string messageOf(const std::string& text) {
  try {
    problemFromJson(text, "p.json");
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

std::string with(const std::string& key, const json& value) {
  json problem = thesis();
  problem[key] = value;
  return problem.dump();
}

}  // namespace

TEST_F(Program, DesignWritesACertifiedAnswer) {
  const std::string problem = write("problem.json", kThesis);
  ASSERT_EQ(run("design " + problem), 0) << stderr_;
  EXPECT_EQ(stderr_, "");
  const json out = answer();
  EXPECT_EQ(out["status"], "solved");
  EXPECT_EQ(out["method"], "global");
  EXPECT_NEAR(out["gamma_e"].get<double>(), 3.29389, 1e-4);  // B is rounded to six digits
  EXPECT_LE(out["gap"].get<double>(), 1e-8);
  EXPECT_GE(out["lambda_min"].get<double>(), 1.0 - 1e-12);
  EXPECT_EQ(out["amplitudes"].size(), 4u);
  EXPECT_EQ(out["certificate"].size(), 3u);
  for (const char* key : {"lower_bound", "iterations", "seconds"})
    EXPECT_TRUE(out.contains(key)) << key;
  for (const json& iteration : out["iterations"])
    EXPECT_TRUE(iteration.contains("gamma_e") && iteration.contains("step"));
  ASSERT_EQ(run("design " + problem + " --out answer.json"), 0);
  EXPECT_EQ(stdout_, "");
  EXPECT_EQ(json::parse(quad_support::readFile((dir_ / "answer.json").string()))["gamma_e"],
            out["gamma_e"]);
}

TEST_F(Program, DesignWithBothPhasesAndByMajorisation) {
  ASSERT_EQ(run("design " + write("both.json", with("phase", "both"))), 0) << stderr_;
  EXPECT_EQ(answer()["amplitudes"]["cos"].size(), 4u);
  EXPECT_EQ(answer()["amplitudes"]["sin"].size(), 4u);
  ASSERT_EQ(run("design --method mm --cost-tolerance 1e-4 --step-tolerance 1e-2 " +
                write("cos.json", with("phase", "cos"))),
            0);
  EXPECT_EQ(answer()["method"], "mm");
  EXPECT_GT(answer()["iterations"].size(), 2u);
  EXPECT_NEAR(answer()["gamma_e"].get<double>(), 3.319, 0.01);
}

TEST_F(Program, MajorisationStartsAtTheGivenCandidate) {
  const std::string problem = write("problem.json", kThesis);
  const std::string mm = "design " + problem + " --method mm ";
  ASSERT_EQ(run(mm + "--out answer.json"), 0) << stderr_;
  ASSERT_EQ(run(mm + "--initial answer.json"), 0) << stderr_;
  const json fresh = json::parse(quad_support::readFile((dir_ / "answer.json").string()));
  // Started at its own answer it has little to do but see that it is one.
  EXPECT_LT(answer()["iterations"].size(), fresh["iterations"].size() / 2);
  EXPECT_LE(answer()["gamma_e"].get<double>(),
            fresh["gamma_e"].get<double>() * (1 + 1e-9));  // descent
  ASSERT_EQ(
      run(mm + "--max-iterations 1 --initial " + write("twice.json", "[[1], [-2], [3], [0.5]]")), 3)
      << stderr_;
  const json first = answer()["iterations"][0]["amplitudes"];
  ASSERT_EQ(run(mm + "--max-iterations 1"), 3);
  EXPECT_NE(answer()["iterations"][0]["amplitudes"], first);
  ASSERT_EQ(run("design " + write("both.json", with("phase", "both")) + " --method mm --initial " +
                write("cs.json", R"({"cos": [[1], [1], [1], [1]], "sin": [[0], [1], [0], [1]]})") +
                " --cost-tolerance 1e-3 --step-tolerance 1e-1"),
            0)
      << stderr_;
}

TEST_F(Program, InitialCandidatesOfTheWrongShapeExitWith2) {
  const std::string mm = "design " + write("p.json", kThesis) + " --method mm --initial ";
  EXPECT_EQ(run(mm + write("i.json", "[[1], [2], [3]]")), 2);
  EXPECT_NE(stderr_.find("i.json: amplitudes are 3 x 1; must be 4 carriers x 1 inputs"),
            std::string::npos)
      << stderr_;
  for (const char* text : {"[[1, 1], [2, 1], [3, 1], [4, 1]]", "[1, 2, 3, 4]", "{\"cos\": [[1]]}",
                           "[", "[[1], [2], [3], [\"4\"]]", "{\"amplitudes\": null}", "3"}) {
    EXPECT_EQ(run(mm + write("i.json", text)), 2) << text;
  }
  EXPECT_EQ(run(mm + "nofile.json"), 2);
  EXPECT_EQ(run("design p.json --initial " + write("i.json", "[[1], [2], [3], [4]]")), 2);
  EXPECT_NE(stderr_.find("--initial has no effect on method global"), std::string::npos) << stderr_;
  EXPECT_EQ(
      run("design " + write("b.json", with("phase", "both")) + " --method mm --initial i.json"), 2);
}

TEST_F(Program, NegativeAnswersExitWith3AndAreWritten) {
  EXPECT_EQ(run("design " + write("dead.json", with("B", {{0.0}, {0.0}}))), 3);
  EXPECT_EQ(answer()["status"], "not_exciting");
  EXPECT_TRUE(answer()["gamma_e"].is_null());
  EXPECT_NE(stderr_.find("dead.json: not_exciting: "), std::string::npos) << stderr_;
  EXPECT_EQ(run("design --method mm --max-iterations 2 " + write("p.json", kThesis)), 3);
  EXPECT_EQ(answer()["status"], "iteration_limit");
  EXPECT_TRUE(answer()["gamma_e"].is_number());
}

TEST_F(Program, BadInputExitsWith2AndOneLine) {
  for (const std::string& arguments :
       {std::string("design"), std::string("design nofile.json"), std::string(""),
        std::string("desing p.json"), "design " + write("p.json", kThesis) + " --method best",
        "design " + write("q.json", "{"), "design " + write("r.json", with("gamma_w", 0)),
        "identify " + write("d.csv", data(0.0)) + " --states x --inputs u",
        "identify " + write("d.csv", data(0.0)) + " --states y --inputs u --gamma-w 1",
        "identify " + write("d.csv", data(0.0)) + " --states x --inputs u --gamma-w 0",
        "identify " + write("d.csv", data(0.0)) +
            " --states x --inputs u --gamma-w 1 --where phase=hold"}) {
    SCOPED_TRACE(arguments);
    EXPECT_EQ(run(arguments), 2);
    EXPECT_EQ(stdout_, "");
    EXPECT_EQ(stderr_.rfind("explore_opt: ", 0), 0u) << stderr_;
    EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), 1) << stderr_;
  }
}

TEST_F(Program, OutputThatCannotBeWrittenExitsWith5) {
  EXPECT_EQ(run("design " + write("p.json", kThesis) + " --out no/such/folder/a.json"), 5);
}

TEST_F(Program, IdentifySelectsRowsAndJudges) {
  const std::string file = write("data.csv", data(0.01));
  const std::string common = "identify " + file + " --states x --inputs u --where phase=explore ";
  ASSERT_EQ(run(common + "--gamma-w 0.01 --D 20"), 0) << stderr_;
  const json out = answer();
  EXPECT_NEAR(out["Theta"][0][0].get<double>(), 0.5, 0.02);
  EXPECT_NEAR(out["Theta"][0][1].get<double>(), 0.4, 0.02);
  EXPECT_DOUBLE_EQ(out["G"].get<double>(), 0.01 - out["residual_energy"].get<double>());
  EXPECT_NEAR(out["residual_energy"].get<double>(), 40 * 1e-4,
              5e-4);  // 40 samples of ±0.01, a little fitted away
  EXPECT_EQ(out["exploration_condition"], true);
  EXPECT_EQ(out["falsified"], false);
  EXPECT_GT(out["lambda_D_bd"].get<double>(), 20.0);

  EXPECT_EQ(run(common + "--gamma-w 0.01"), 0);
  EXPECT_TRUE(answer()["exploration_condition"].is_null());  // nothing asked for, nothing judged
  EXPECT_EQ(run(common + "--gamma-w 0.01 --D 1e6"), 3);
  EXPECT_EQ(answer()["exploration_condition"], false);
  EXPECT_NE(stderr_.find("exploration condition not met"), std::string::npos);
  EXPECT_EQ(run(common + "--gamma-w 0.001 --D 20"), 3);
  EXPECT_EQ(answer()["falsified"], true);
  EXPECT_TRUE(answer()["lambda_D_bd"].is_null());
  EXPECT_NE(stderr_.find("gamma_w = 0.001 is smaller than the residual energy"), std::string::npos);
}

TEST_F(Program, IdentifyTakesMatricesAndKnownEntries) {
  const std::string common = "identify " + write("data.csv", data(0.01)) +
                             " --states x --inputs u --where phase=explore --gamma-w 0.01 ";
  EXPECT_EQ(run(common + "--D " + write("D.json", "[[20, 1], [1, 30]]")), 0) << stderr_;
  EXPECT_EQ(run(common + "--D " + write("D3.json", "[[20, 1, 0], [1, 30, 0], [0, 0, 1]]")), 2);
  ASSERT_EQ(run(common + "--D 20 --known " + write("known.json", "[[0.5, null]]")), 0) << stderr_;
  EXPECT_EQ(answer()["Theta"][0][0], 0.5);
  EXPECT_EQ(answer()["information"].size(), 1u);
  EXPECT_EQ(answer()["free"], json::parse("[[0, 1]]"));
  EXPECT_EQ(run(common + "--known " + write("all.json", "[[0.5, 0.4]]")), 2);
  EXPECT_EQ(run(common + "--known " + write("shape.json", "[[0.5]]")), 2);
}

TEST_F(Program, IdentifyTellsIntervalsMembershipAndFusesFiles) {
  const std::string first = write("first.csv", data(0.01)),
                    second = write("second.csv", data(0.005));
  const std::string options = " --states x --inputs u --where phase=explore ";
  ASSERT_EQ(run("identify " + first + options +
                "--gamma-w 0.01 --function 'gain = B1/A11' --function B1 --contains " +
                write("truth.json", "[[0.5, 0.4]]")),
            0)
      << stderr_;
  EXPECT_LT(answer()["lower"][0][1].get<double>(), 0.4);
  EXPECT_GT(answer()["upper"][0][1].get<double>(), 0.4);
  EXPECT_EQ(answer()["functions"][0]["name"], "gain");
  EXPECT_LT(answer()["functions"][0]["lower"].get<double>(), 0.8);
  EXPECT_GT(answer()["functions"][0]["upper"].get<double>(), 0.8);
  EXPECT_EQ(answer()["functions"][1]["upper"], answer()["upper"][0][1]);
  EXPECT_EQ(answer()["candidate"]["member"], true);
  const double alone = answer()["lambda_D_bd"].get<double>();
  EXPECT_EQ(run("identify " + first + options + "--gamma-w 0.01 --contains " +
                write("far.json", "[[0.5, 0.9]]")),
            3);
  EXPECT_NE(stderr_.find("is not among the parameters"), std::string::npos) << stderr_;

  ASSERT_EQ(run("identify " + first + " " + second + options + "--gamma-w 0.01,0.002"), 0)
      << stderr_;
  EXPECT_EQ(answer()["data_sets"].size(), 2u);
  EXPECT_EQ(answer()["weights"].size(), 2u);
  EXPECT_GT(answer()["lambda_D_bd"].get<double>(), alone);
  EXPECT_EQ(run("identify " + first + " " + second + options + "--gamma-w 0.01,0.002,1"), 2);
  EXPECT_EQ(run("identify " + first + options + "--gamma-w 0.01 --function A12"), 2);
  EXPECT_EQ(run("identify " + first + options + "--gamma-w 0.01 --contains " +
                write("bad.json", "[[0.5]]")),
            2);
}

TEST_F(Program, AuditPassesHonestDesignsAndFindsOthers) {
  const std::string problem = write("problem.json", kThesis);
  ASSERT_EQ(run("design " + problem + " --out design.json"), 0);
  ASSERT_EQ(run("audit " + problem + " design.json"), 0) << stderr_;
  EXPECT_EQ(answer()["passed"], true);
  EXPECT_NE(stderr_.find("ok     lower_bound"), std::string::npos) << stderr_;
  json design = json::parse(quad_support::readFile((dir_ / "design.json").string()));
  design["amplitudes"][3][0] = design["amplitudes"][3][0].get<double>() * 0.9;
  EXPECT_EQ(
      run("audit " + problem + " " + write("cheap.json", design.dump()) + " --out audit.json"), 3);
  EXPECT_NE(stdout_.find("WRONG  feasible"), std::string::npos) << stdout_;
  EXPECT_EQ(run("audit " + problem + " " + write("no.json", "{}")), 2);
}

TEST_F(Program, PredictionOfADesignMeetsItsPromise) {
  const std::string problem = write("problem.json", kThesis);
  ASSERT_EQ(run("design " + problem + " --out design.json"), 0);
  ASSERT_EQ(run("predict " + problem + " design.json --out prediction.csv"), 0) << stderr_;
  // Without noise the residual is zero, G = gamma_w, and the condition just holds.
  ASSERT_EQ(run("identify prediction.csv --states x1,x2 --inputs u1 --gamma-w 20 --D 99.9999"), 0)
      << stderr_;
  EXPECT_NEAR(answer()["Theta"][0][1].get<double>(), 0.1635, 1e-12);
  EXPECT_NEAR(answer()["lambda_D_bd"].get<double>(), 100.0, 1e-6);
  EXPECT_LT(answer()["residual_energy"].get<double>(), 1e-20);
  EXPECT_EQ(run("predict " + problem + " " + write("short.json", "[[1], [2]]")), 2);
}

TEST_F(Program, SolvesCanBeDumpedAndReplayed) {
  const std::string problem = write("problem.json", kThesis);
  for (const std::string& method :
       {std::string("global"),
        std::string("mm --initial ") + write("i.json", "[[1], [2], [3], [4]]")}) {
    ASSERT_EQ(run("design " + problem + " --method " + method +
                  " --seed 7 --dump dump.json --out design.json"),
              0);
    ASSERT_EQ(run("replay dump.json"), 0) << stderr_;
    const json first = json::parse(quad_support::readFile((dir_ / "design.json").string()));
    EXPECT_EQ(answer()["amplitudes"], first["amplitudes"]);  // the same program: the same bits
  }
  json dump = json::parse(quad_support::readFile((dir_ / "dump.json").string()));
  dump["answer"]["gamma_e"] = 3.0;
  EXPECT_EQ(run("replay " + write("other.json", dump.dump())), 3);
  EXPECT_NE(stderr_.find("recorded solved, gamma_e 3"), std::string::npos) << stderr_;
  dump["options"].erase("seed");
  EXPECT_EQ(run("replay " + write("broken.json", dump.dump())), 2);
  EXPECT_EQ(run("replay " + problem), 2);
  // A failure can be dumped too.
  EXPECT_EQ(run("design " + write("dead.json", with("B", {{0.0}, {0.0}})) + " --dump dump.json"),
            3);
  EXPECT_EQ(run("replay dump.json"), 0) << stderr_;
}

TEST_F(Program, FrequenciesWriteAProblemReadyForDesign) {
  json system = thesis();
  system.erase("harmonics");
  const std::string file = write("system.json", system.dump());
  ASSERT_EQ(run("frequencies " + file + " --lines 4 --problem problem.json --band 0.005 0.2"), 0)
      << stderr_;
  EXPECT_EQ(answer()["harmonics"].size(), 4u);
  EXPECT_EQ(answer()["bode"]["frequency"].size(), answer()["bode"]["gain"].size());
  EXPECT_EQ(run("design problem.json"), 0) << stderr_;
  EXPECT_EQ(run("frequencies " + file + " --band 0.3 0.2"), 2);
  system["A"] = {{1.2, 0}, {0, 0.5}};
  EXPECT_EQ(run("frequencies " + write("unstable.json", system.dump())), 3);
  EXPECT_NE(stderr_.find("Add a stabilising K"), std::string::npos) << stderr_;
}

TEST_F(Program, DataThatDoNotExciteExitWith3) {
  EXPECT_EQ(run("identify " + write("still.csv", "x,u\n1,0\n0.5,0\n0.25,0\n0.125,0\n") +
                " --states x --inputs u --gamma-w 1"),
            3);
  EXPECT_EQ(answer()["exciting"], false);
  EXPECT_TRUE(answer()["Theta"].is_null());
}

TEST_F(Program, HelpHasExamplesThatRun) {
  ASSERT_EQ(run("--help"), 0);
  std::istringstream overview(stdout_.substr(stdout_.find("Subcommands:\n") + 13));
  int tried = 0;
  for (std::string line; std::getline(overview, line) && line.rfind("  ", 0) == 0;) {
    const std::string command = line.substr(2, line.find(' ', 2) - 2);
    if (command.empty()) continue;  // the description goes on
    ++tried;
    SCOPED_TRACE(command);
    ASSERT_EQ(run(command + " --help"), 0);
    // Indented lines below "Example:".
    const auto begin = stdout_.find("Example:\n");
    ASSERT_TRUE(begin != std::string::npos);
    std::istringstream text(stdout_.substr(begin + 9));
    std::string script;
    for (std::string row; std::getline(text, row) && row.rfind("  ", 0) == 0;) script += row + "\n";
    const std::string folder = fs::path(EXPLORE_OPT_PROGRAM).parent_path().string();
    write("example.sh", "set -e\nPATH=" + folder + ":$PATH\n" + script + "\n");
    EXPECT_EQ(
        std::system(("cd '" + dir_.string() + "' && sh example.sh >example.out 2>&1").c_str()), 0)
        << script << quad_support::readFile((dir_ / "example.out").string());
  }
  EXPECT_GE(tried, 3);
}

TEST(ProblemJson, ReadsEveryKey) {
  json object = thesis();
  object["D_des"] = {{2, 0.5, 0}, {0.5, 3, 0}, {0, 0, 4}};
  object["K"] = {{-1, -2}};
  object["x0"] = {0.5, 0};
  object["cost"] = "input";
  object["known"] = {{1, nullptr, nullptr}, {0, nullptr, nullptr}};
  object["u_max"] = 4.5;
  object["experiments"] = 2;
  const ExplorationProblem problem = problemFromJson(object.dump(), "p.json");
  EXPECT_EQ(problem.A(0, 1), 0.1635);
  EXPECT_EQ(problem.lines.num_samples, 370);
  EXPECT_EQ(problem.lines.harmonics, (std::vector<int>{3, 6, 8, 10}));
  EXPECT_EQ(problem.phase, Phase::kSin);
  EXPECT_EQ(problem.D_des(1, 0), 0.5);
  EXPECT_EQ(problem.K(0, 1), -2.0);
  EXPECT_EQ(problem.x0(0), 0.5);
  EXPECT_EQ(problem.cost, CostOn::kInput);
  EXPECT_EQ(problem.known(1, 0), 0.0);
  EXPECT_TRUE(std::isnan(problem.known(1, 2)));
  EXPECT_EQ(problem.u_max, Eigen::VectorXd::Constant(1, 4.5));
  EXPECT_EQ(problem.experiments, 2);
}

TEST(ProblemJson, SaysWhatIsWrong) {
  EXPECT_EQ(messageOf(kThesis), "");
  EXPECT_EQ(messageOf(with("gamma_w", -1)),
            "p.json: gamma_w = -1; must be a finite number above 0");
  EXPECT_EQ(messageOf(with("harmonics", {3, 200})),
            "p.json: harmonics[1] = 200; must lie in 1..184 (below T/2, T = 370)");
  EXPECT_EQ(messageOf(with("phase", "sine")), "p.json: phase = 'sine'; must be sin, cos or both");
  EXPECT_EQ(messageOf(with("B", {{0.02}, {0.2, 1}})),
            "p.json: B: row 2 is [0.2,1]; must have 1 numbers like the first");
  EXPECT_EQ(messageOf(with("T", 37.5)), "p.json: T = 37.5; must be a whole number, 0 to 1e9");
  EXPECT_NE(messageOf(with("gama_w", 1)).find("p.json: gama_w is not a key"), std::string::npos);
  EXPECT_NE(messageOf(with("gamma_w", "20")), "");
  EXPECT_NE(messageOf(with("A", 1)), "");
  EXPECT_NE(messageOf(with("frequencies", {0.1})), "");  // beside harmonics
  EXPECT_NE(messageOf(with("x0", {1, 0, 0})), "");
  EXPECT_NE(messageOf(with("known", {{1, nullptr}})), "");
  EXPECT_NE(messageOf(with("u_max", "1")), "");
  EXPECT_NE(messageOf("[]"), "");
  EXPECT_NE(messageOf("{\"A\": [[1]]"), "");
  EXPECT_EQ(messageOf("{\"A\": 1, \"A\": 2}"), "p.json: key \"A\" is given twice");
  for (const char* key : {"A", "B", "T", "phase", "gamma_w", "D_des"}) {
    json object = thesis();
    object.erase(key);
    EXPECT_EQ(messageOf(object.dump()), std::string("p.json: ") + key + " is missing");
  }
}

TEST(ProblemJson, NumbersSurviveTheRoundTrip) {
  const ExplorationProblem problem = explore_opt::testing::thesisProblem(Phase::kBoth);
  const DesignResult result = designExploration(problem);
  const json back = json::parse(prettyJson(designToJson(problem, result)));
  EXPECT_EQ(back["gamma_e"].get<double>(), result.gamma_e);
  EXPECT_EQ(back["amplitudes"]["sin"][3][0].get<double>(), result.amplitudes(7, 0));
  EXPECT_EQ(back["certificate"][2][1].get<double>(), result.certificate(2, 1));
}
