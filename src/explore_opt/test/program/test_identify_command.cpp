/// explore_opt identify.
#include "program_fixture.hpp"

using namespace explore_opt::testing;

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

TEST_F(Program, DataThatDoNotExciteExitWith3) {
  EXPECT_EQ(run("identify " + write("still.csv", "x,u\n1,0\n0.5,0\n0.25,0\n0.125,0\n") +
                " --states x --inputs u --gamma-w 1"),
            3);
  EXPECT_EQ(answer()["exciting"], false);
  EXPECT_TRUE(answer()["Theta"].is_null());
  EXPECT_TRUE(answer()["exploration_condition"].is_null());  // was not asked for
  EXPECT_EQ(run("identify still.csv --states x --inputs u --gamma-w 1 --D 2"), 3);
  EXPECT_EQ(answer()["exploration_condition"], false);
}

TEST_F(Program, PredictedDataMeetTheConditionTheyWereDesignedFor) {
  for (const double D_des : {0.3, 1.0, 4.0, 33.0}) {  // on the boundary to the last digit or two
    const std::string problem = write("problem.json", with("D_des", D_des));
    ASSERT_EQ(run("design " + problem + " --out design.json"), 0) << stderr_;
    ASSERT_EQ(run("predict " + problem + " design.json --out data.csv"), 0) << stderr_;
    EXPECT_EQ(run("identify data.csv --states x1,x2 --inputs u1 --gamma-w 20 --D " +
                  std::to_string(D_des)),
              0)
        << stderr_;
  }
}

TEST_F(Program, IdentifyTakesDataThatOnlyTogetherDetermineAll) {
  // x⁺ = 0.5 x + 0.4 u + 0.3 v; each file moves one input alone.
  const auto table = [](bool first) {
    std::string text = "x,u,v\n";
    double x = 1.0;
    for (int k = 0; k < 20; ++k) {
      const double move = std::cos(1.3 * k), u = first ? move : 0.0, v = first ? 0.0 : move;
      text += quad_support::shortest(x) + "," + quad_support::shortest(u) + "," +
              quad_support::shortest(v) + "\n";
      x = 0.5 * x + 0.4 * u + 0.3 * v + (k % 2 == 0 ? 1e-3 : -1e-3);
    }
    return text;
  };
  const std::string a = write("a.csv", table(true)), b = write("b.csv", table(false)),
                    options = " --states x --inputs u,v --gamma-w 1e-4 ";
  EXPECT_EQ(run("identify " + a + options), 3);
  EXPECT_EQ(answer()["exciting"], false);
  EXPECT_EQ(run("identify " + a + " " + a + options), 3);
  EXPECT_NE(stderr_.find("not even together"), std::string::npos) << stderr_;
  ASSERT_EQ(run("identify " + a + " " + b + options + "--D 100 --contains " +
                write("truth.json", "[[0.5, 0.4, 0.3]]")),
            0)
      << stderr_;
  EXPECT_EQ(answer()["candidate"]["member"], true);
  EXPECT_NEAR(answer()["Theta"][0][1].get<double>(), 0.4, 1e-3);
  EXPECT_NEAR(answer()["Theta"][0][2].get<double>(), 0.3, 1e-3);
  EXPECT_TRUE(answer()["data_sets"][0]["Theta"].is_null());
  EXPECT_EQ(answer()["data_sets"][0]["exciting"], false);
}

TEST_F(Program, IdentifyRefusesAnIndefiniteClosenessWhereItIsRead) {
  const std::string common = "identify " + write("data.csv", data(0.01)) +
                             " --states x --inputs u --where phase=explore --gamma-w 0.01 --D ";
  EXPECT_EQ(run(common + write("D.json", "[[1, 2], [2, 1]]")), 2);
  EXPECT_NE(stderr_.find("D.json: D has the eigenvalue -"), std::string::npos) << stderr_;
  EXPECT_EQ(run(common + "-5"), 2);
  EXPECT_NE(stderr_.find("--D has the eigenvalue -5"), std::string::npos) << stderr_;
  EXPECT_EQ(run(common + write("D.json", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")), 2);
  EXPECT_NE(stderr_.find("D.json: "), std::string::npos) << stderr_;
  EXPECT_EQ(run("identify " + write("short.csv", "x,u\n1,1\n2,0\n") +
                " --states x --inputs u --gamma-w 1"),
            2);
  EXPECT_NE(stderr_.find("short.csv: "), std::string::npos) << stderr_;
}
