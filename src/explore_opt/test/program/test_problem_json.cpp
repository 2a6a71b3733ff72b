/// Problems as JSON: what is read, what is refused and why, what survives.
#include <cmath>

#include "explore_opt/design_json.hpp"
#include "program_fixture.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using namespace explore_opt::testing;

namespace {

std::string messageOf(const std::string& text) {
  try {
    problemFromJson(text, "p.json");
  } catch (const quad_support::ConfigError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

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
