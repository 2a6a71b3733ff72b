/// explore_opt design: answers, candidates, negative answers.
#include "program_fixture.hpp"

using namespace explore_opt::testing;

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

TEST_F(Program, MajorisationDesignsSeveralExperiments) {
  json problem = thesis();
  problem["experiments"] = 2;
  problem["phase"] = "cos";
  const std::string file = write("two.json", problem.dump());
  ASSERT_EQ(run("design " + file + " --method mm --out mm.json"), 0) << stderr_;
  const json mm = json::parse(quad_support::readFile((dir_ / "mm.json").string()));
  ASSERT_EQ(run("audit " + file + " mm.json"), 0) << stderr_;
  ASSERT_EQ(mm["experiments"].size(), 2u);
  EXPECT_NE(mm["experiments"][0], mm["experiments"][1]);
  // One experiment reaches the bound here, 3.31937 at the printed B; the relaxed bound is the same.
  EXPECT_NEAR(mm["gamma_e"].get<double>(), 3.3194, 0.01);
  EXPECT_LE(mm["gap"].get<double>(), 3e-3);
  ASSERT_EQ(run("design " + file + " --method mm --initial mm.json"), 0) << stderr_;
  EXPECT_LE(answer()["gamma_e"].get<double>(), mm["gamma_e"].get<double>() * (1 + 1e-9));
  problem.erase("experiments");
  problem["u_max"] = 5;
  EXPECT_EQ(run("design " + write("peak.json", problem.dump()) + " --method mm"), 2);
  EXPECT_NE(stderr_.find("use method global"), std::string::npos) << stderr_;
}

TEST_F(Program, StartsHaveALimit) {
  const std::string problem = write("problem.json", kThesis);
  EXPECT_EQ(run("design " + problem + " --starts 10001"), 2);
  EXPECT_NE(stderr_.find("random starts = 10001; must lie in 0..10000"), std::string::npos)
      << stderr_;
  EXPECT_EQ(run("design " + problem + " --starts 0"), 0) << stderr_;
}

TEST_F(Program, OptionsWithoutEffectAreRefused) {
  const std::string problem = write("problem.json", kThesis);
  for (const char* option : {"--plain", "--max-iterations 7", "--cost-tolerance 1e-3",
                             "--step-tolerance 1e-3", "--initial problem.json"}) {
    EXPECT_EQ(run("design " + problem + " " + option), 2) << option;
    EXPECT_NE(stderr_.find("has no effect on method global; add --method mm"), std::string::npos)
        << stderr_;
  }
  EXPECT_EQ(run("design " + problem + " --method mm --starts 3"), 2);
  EXPECT_NE(stderr_.find("--starts has no effect on method mm"), std::string::npos) << stderr_;
  EXPECT_EQ(run("design " + problem + " --seed -1"), 2);
  EXPECT_NE(stderr_.find("--seed"), std::string::npos) << stderr_;
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

TEST_F(Program, OutputThatCannotBeWrittenExitsWith5) {
  EXPECT_EQ(run("design " + write("p.json", kThesis) + " --out no/such/folder/a.json"), 5);
  EXPECT_EQ(run("design " + write("p.json", kThesis) + " --dump no/such/folder/d.json"), 5);
  EXPECT_EQ(answer()["status"], "solved");  // what can be written is
}
