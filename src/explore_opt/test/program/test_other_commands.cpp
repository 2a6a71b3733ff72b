/// explore_opt audit, baselines, predict, frequencies, replay; what all subcommands share.
#include <algorithm>

#include "program_fixture.hpp"
#include "quad_support/command_line.hpp"

using namespace explore_opt::testing;

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
  design["amplitudes"].erase(3);
  EXPECT_EQ(run("audit " + problem + " " + write("short.json", design.dump())), 2);
  EXPECT_NE(stderr_.find("short.json: amplitudes are 3 x 1"), std::string::npos) << stderr_;
}

TEST_F(Program, PredictionOfADesignMeetsItsPromise) {
  const std::string problem = write("problem.json", kThesis);
  ASSERT_EQ(run("design " + problem + " --out design.json"), 0);
  ASSERT_EQ(run("predict " + problem + " design.json --out prediction.csv"), 0) << stderr_;
  // Without noise the residual is zero, G = gamma_w, and the condition just holds.
  ASSERT_EQ(run("identify prediction.csv --states x1,x2 --inputs u1 --gamma-w 20 --D 100"), 0)
      << stderr_;
  EXPECT_NEAR(answer()["Theta"][0][1].get<double>(), 0.1635, 1e-12);
  EXPECT_NEAR(answer()["lambda_D_bd"].get<double>(), 100.0, 1e-6);
  EXPECT_LT(answer()["residual_energy"].get<double>(), 1e-20);
  EXPECT_EQ(run("predict " + problem + " " + write("short.json", "[[1], [2]]")), 2);
}

TEST_F(Program, SeveralExperimentsArePredictedAndComparedTogether) {
  // One phase and two inputs: one experiment is far from the bound, two reach it.
  const std::string problem = write("two.json", R"({"A": [[0.6, 0.2], [-0.1, 0.7]],
    "B": [[1, 0.2], [0.1, 1]], "T": 60, "harmonics": [4, 9], "phase": "cos", "gamma_w": 1, "D_des": 5,
    "experiments": 2})");
  ASSERT_EQ(run("design " + problem + " --out design.json"), 0) << stderr_;
  ASSERT_EQ(run("predict " + problem + " design.json --out all.csv"), 0) << stderr_;
  const std::string all = quad_support::readFile((dir_ / "all.csv").string());
  EXPECT_EQ(all.rfind("run,k,x1,x2,u1,u2\n1,0,0,0,", 0), 0u) << all.substr(0, 60);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 1 + 2 * 61);
  for (const char* i : {"1", "2"}) {
    const std::string number = i;
    ASSERT_EQ(
        run("predict " + problem + " design.json --run " + number + " --out run" + number + ".csv"),
        0)
        << stderr_;
    const std::string options = " --states x1,x2 --inputs u1,u2 --gamma-w 1 ";
    ASSERT_EQ(run("identify run" + number + ".csv" + options), 0) << stderr_;
    const json alone = answer();
    ASSERT_EQ(run("identify all.csv --where run=" + number + options), 0) << stderr_;
    EXPECT_EQ(answer()["Theta"], alone["Theta"]);
  }
  // Equal weights: the mean information of both against gamma_w, which is what the design promises.
  ASSERT_EQ(run("identify run1.csv run2.csv --states x1,x2 --inputs u1,u2 --gamma-w 1 --D 4.9999"),
            0)
      << stderr_;
  EXPECT_EQ(run("predict " + problem + " design.json --run 3"), 2);
  EXPECT_NE(stderr_.find("--run 3; must be 0 (all) or one of the experiments 1..2"),
            std::string::npos)
      << stderr_;

  ASSERT_EQ(run("baselines " + problem + " --seeds 3 --out baselines.json"), 0) << stderr_;
  const json rows = json::parse(quad_support::readFile((dir_ / "baselines.json").string()));
  const double targeted = rows["gamma_e"].get<double>();
  EXPECT_EQ(rows["signals"][0]["name"], "targeted");
  EXPECT_NEAR(rows["signals"][0]["cost"].get<double>(), targeted, 1e-6 * targeted);
  for (std::size_t i = 1; i < 4; ++i) {  // D-, A-, E-optimal: on the same lines, so never cheaper
    const json& row = rows["signals"][i];
    if (row["cost"].is_null()) continue;
    EXPECT_GE(row["cost"].get<double>(), targeted * (1 - 1e-6)) << row["name"];
  }
}

TEST_F(Program, BaselinesAndFrequenciesLeaveKnownEntriesAlone) {
  // No input moves the second state, and nothing is asked about it.
  const std::string problem = write("known.json", R"({"A": [[0.9, 0], [0, 0.5]], "B": [[1], [0]],
    "T": 100, "harmonics": [3, 11], "phase": "cos", "gamma_w": 1, "D_des": 10,
    "known": [[null, 0, null], [0, 0.5, 0]]})");
  ASSERT_EQ(run("baselines " + problem + " --seeds 2"), 0) << stderr_;
  EXPECT_EQ(stderr_.find("nan"), std::string::npos) << stderr_;
  const json rows = answer();
  const double targeted = rows["gamma_e"].get<double>();
  EXPECT_NEAR(rows["signals"][0]["cost"].get<double>(), targeted, 1e-10 * targeted);
  for (const json& row : rows["signals"]) EXPECT_FALSE(row["cost"].is_null()) << row["name"];
  ASSERT_EQ(run("frequencies " + problem + " --problem chosen.json"), 0) << stderr_;
  EXPECT_EQ(run("design chosen.json"), 0) << stderr_;
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
  const std::string unstable = write("unstable.json", system.dump());
  EXPECT_EQ(run("frequencies " + unstable), 3);
  EXPECT_NE(stderr_.find("Add a stabilising K"), std::string::npos) << stderr_;
  EXPECT_EQ(stderr_.rfind("explore_opt: " + unstable + ": the system is unstable", 0), 0u)
      << stderr_;
}

TEST_F(Program, SaysItsVersionAndItsCommands) {
  ASSERT_EQ(run("--version"), 0);
  EXPECT_EQ(stdout_, std::string(quad_support::kVersion) + "\n");
  EXPECT_EQ(run("desing p.json"), 2);
  EXPECT_NE(stderr_.find("desing: no such command, did you mean design?"), std::string::npos)
      << stderr_;
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
