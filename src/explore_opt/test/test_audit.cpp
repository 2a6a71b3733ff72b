/// The audit agrees with honest designs and finds what was tampered with.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explore_opt/audit.hpp"
#include "explore_opt/design_json.hpp"
#include "quad_support/errors.hpp"
#include "thesis_problem.hpp"

using namespace explore_opt;
using explore_opt::testing::randomMatrix;
using explore_opt::testing::thesisProblem;

namespace {

DesignClaims claimsOf(const ExplorationProblem& problem, const DesignResult& design) {
  return claimsFromJson(designToJson(problem, design).dump(), "design.json", problem);
}

/// Names of the checks that failed.
std::string failures(const ExplorationProblem& problem, const DesignClaims& claims) {
  std::string names;
  for (const AuditCheck& check : audit(problem, claims).checks)
    if (!check.passed) names += check.name + " ";
  return names;
}

ExplorationProblem randomProblem(std::uint64_t seed) {
  const int nx = 1 + static_cast<int>(seed % 3), nu = 1 + static_cast<int>(seed % 2),
            n = seed % 4 < 2 ? nx + nu : nx * (nx + nu);
  ExplorationProblem problem;
  problem.A = 0.25 * randomMatrix(seed, 0, nx, nx);
  problem.B = randomMatrix(seed, 1, nx, nu);
  if (seed % 5 == 0) problem.K = 0.05 * randomMatrix(seed, 2, nu, nx);
  problem.lines = {120, {2, 9, 17, 31}, {}};
  if (seed % 3 == 0) problem.lines = {100, {}, {0.0213, 0.1, 0.2718, 0.45}};
  problem.phase = seed % 2 == 0 ? Phase::kSin : Phase::kBoth;
  problem.gamma_w = 0.7;
  const Eigen::MatrixXd root = randomMatrix(seed, 3, n, n);
  problem.D_des = root * root.transpose() + 0.3 * Eigen::MatrixXd::Identity(n, n);
  problem.D_des = (0.5 * (problem.D_des + problem.D_des.transpose())).eval();
  return problem;
}

}  // namespace

TEST(Audit, AgreesWithTheThesisDesigns) {
  for (const Phase phase : {Phase::kSin, Phase::kCos, Phase::kBoth}) {
    const ExplorationProblem problem = thesisProblem(phase);
    const DesignResult design = designExploration(problem);
    const AuditReport report = audit(problem, claimsOf(problem, design));
    for (const AuditCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.finding;
    EXPECT_NEAR(report.gamma_e, design.gamma_e, 1e-12);
    EXPECT_NEAR(report.lower_bound, design.lower_bound, 1e-9);
    EXPECT_NEAR(report.lambda_min, design.lambda_min, 1e-10);  // λ_max/λ_min of N is 1e4
    EXPECT_LE(report.gap, 1e-5);
  }
}

TEST(Audit, AgreesWithDesignsOfManyKinds) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const ExplorationProblem problem = randomProblem(seed);
    DesignOptions options;
    options.random_starts = 1;
    const DesignResult design = designExploration(problem, options);
    ASSERT_TRUE(design.feasible()) << design.message;
    const AuditReport report = audit(problem, claimsOf(problem, design));
    for (const AuditCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.finding;
    EXPECT_NEAR(report.lower_bound, design.lower_bound, 1e-7 * design.lower_bound);
  }
}

TEST(Audit, AgreesWithTheWholeProblemClass) {
  for (int kind = 0; kind < 7; ++kind) {
    SCOPED_TRACE(kind);
    ExplorationProblem problem = thesisProblem(Phase::kCos);
    if (kind == 0) problem.x0 = Eigen::Vector2d(3.0, -1.0);
    if (kind >= 1) problem.K = (Eigen::MatrixXd(1, 2) << -0.1, -0.4).finished();
    if (kind == 2) problem.cost = CostOn::kInput;
    if (kind == 3) {
      problem.known = Eigen::MatrixXd::Constant(2, 3, NAN);
      problem.known(0, 0) = 1.0;
      problem.known(1, 0) = 0.0;
      problem.known(1, 1) = 1.0;
    }
    if (kind == 4) problem.u_max = Eigen::VectorXd::Constant(1, 5.0);
    if (kind == 5) problem.experiments = 2;
    if (kind == 6) problem.D_des = Eigen::Vector3d(100, 0, 100).asDiagonal();
    const DesignResult design = designExploration(problem);
    ASSERT_TRUE(design.feasible()) << design.message;
    DesignClaims claims = claimsOf(problem, design);
    const AuditReport report = audit(problem, claims);
    for (const AuditCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.finding;
    EXPECT_GE(report.gap, -1e-9);
    claims.amplitudes *= 0.98;
    EXPECT_NE(failures(problem, claims), "");
    claims = claimsOf(problem, design);
    claims.lower_bound *= 1.01;
    EXPECT_NE(failures(problem, claims).find("lower_bound"), std::string::npos);
  }
}

TEST(Audit, FindsWhatWasTamperedWith) {
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  const DesignClaims honest = claimsOf(problem, designExploration(problem));
  ASSERT_EQ(failures(problem, honest), "");

  DesignClaims tampered = honest;
  tampered.amplitudes *= 0.99;  // cheaper than possible
  EXPECT_EQ(failures(problem, tampered), "feasible cost lambda_min ");
  tampered.gamma_e *= 0.99;  // and the claims fitted to it
  tampered.gap = (tampered.gamma_e - tampered.lower_bound) / tampered.gamma_e;
  EXPECT_EQ(failures(problem, tampered), "feasible gap lambda_min ");

  tampered = honest;
  tampered.amplitudes(2, 0) *= -1.0;  // same norm, another direction
  EXPECT_EQ(failures(problem, tampered), "feasible lambda_min ");

  tampered = honest;
  tampered.lower_bound *= 1.001;
  tampered.gamma_e *= 1.001;
  tampered.amplitudes *= 1.001;  // all consistent, but the certificate does not prove it
  EXPECT_EQ(failures(problem, tampered), "lower_bound lambda_min ");

  tampered = honest;
  tampered.gap = 0.5;
  EXPECT_EQ(failures(problem, tampered), "gap ");

  tampered = honest;  // the multiplier alone proves as much as its root, ...
  tampered.multiplier_root = Eigen::MatrixXd();
  EXPECT_EQ(failures(problem, tampered), "");
  tampered.multiplier = Eigen::MatrixXd::Identity(3, 3);  // ... another one less
  EXPECT_EQ(failures(problem, tampered), "lower_bound certificate ");
  tampered.multiplier = honest.multiplier;
  tampered.certificate = -honest.certificate;  // not used, but said
  EXPECT_EQ(failures(problem, tampered), "certificate ");
  tampered = honest;
  tampered.multiplier_root = Eigen::MatrixXd::Identity(3, 3);
  EXPECT_EQ(failures(problem, tampered), "lower_bound multiplier certificate ");
  tampered = honest;  // what the bound does not rest on must fit too
  tampered.multiplier += 0.01 * honest.multiplier.norm() * Eigen::MatrixXd::Identity(3, 3);
  EXPECT_EQ(failures(problem, tampered), "multiplier ");
  tampered = honest;
  tampered.certificate += 0.01 * honest.certificate.norm() * Eigen::MatrixXd::Identity(3, 3);
  EXPECT_EQ(failures(problem, tampered), "certificate ");
  tampered = honest;
  tampered.lambda_min = 5.0;
  EXPECT_EQ(failures(problem, tampered), "lambda_min ");
  tampered = honest;
  tampered.status = "infeasible";
  EXPECT_EQ(failures(problem, tampered), "status ");
  tampered = honest;  // the same signal twice is another experiment
  tampered.amplitudes = honest.amplitudes.replicate(2, 1).eval();
  EXPECT_EQ(failures(problem, tampered), "experiments ");
  tampered = honest;  // another Z proves less
  tampered.certificate = Eigen::MatrixXd::Identity(3, 3);
  tampered.multiplier = tampered.multiplier_root = Eigen::MatrixXd();
  EXPECT_EQ(failures(problem, tampered), "lower_bound ");
  tampered.certificate = -honest.certificate;  // not ⪰ 0: its positive part is nothing
  EXPECT_EQ(failures(problem, tampered), "lower_bound ");
  tampered.certificate = Eigen::MatrixXd();
  EXPECT_EQ(failures(problem, tampered), "lower_bound ");

  // The problem changed behind the design's back.
  for (int change = 0; change < 5; ++change) {
    ExplorationProblem other = problem;
    if (change == 0) other.gamma_w *= 1.01;
    if (change == 1) other.D_des *= 1.01;
    if (change == 2) other.A(0, 1) *= 0.5;
    if (change == 3) other.lines.harmonics[3] = 40;
    if (change == 4) other.phase = Phase::kSin;
    EXPECT_NE(failures(other, honest), "") << change;
  }
}

TEST(Audit, RefusesShapesThatDoNotFit) {
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  const DesignClaims honest = claimsOf(problem, designExploration(problem));
  const Eigen::MatrixXd wrong = Eigen::MatrixXd::Identity(2, 2);
  for (Eigen::MatrixXd DesignClaims::*field :
       {&DesignClaims::amplitudes, &DesignClaims::certificate, &DesignClaims::multiplier,
        &DesignClaims::multiplier_root}) {
    DesignClaims claims = honest;
    claims.*field = wrong;
    EXPECT_THROW(audit(problem, claims), quad_support::DataError);
  }
  auto json = designToJson(problem, designExploration(problem));
  json["experiments"] = {json["amplitudes"]};  // which of the two would be meant?
  EXPECT_THROW(claimsFromJson(json.dump(), "design.json", problem), quad_support::ConfigError);
  EXPECT_THROW(amplitudesFromJson(json.dump(), "design.json", problem), quad_support::ConfigError);
}

/// D_des of rank r, by its root or with a last eigenvalue that rounding leaves.
TEST(Audit, AgreesWhereTheClosenessIsSingular) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    ExplorationProblem problem = randomProblem(seed);
    const Eigen::Index n = problem.D_des.rows(), rank = 1 + static_cast<Eigen::Index>(seed) % n;
    const Eigen::MatrixXd root = randomMatrix(seed, 4, static_cast<int>(n), static_cast<int>(rank));
    problem.D_des = seed == 0 ? Eigen::MatrixXd(Eigen::MatrixXd::Ones(n, n))
                              : Eigen::MatrixXd(root * root.transpose());
    problem.D_des = (0.5 * (problem.D_des + problem.D_des.transpose())).eval();
    if (seed % 4 == 1) problem.x0 = Eigen::VectorXd::LinSpaced(problem.numStates(), 0.5, -1.0);
    DesignOptions options;
    options.random_starts = 2;
    const DesignResult design = designExploration(problem, options);
    ASSERT_TRUE(design.feasible()) << design.message;
    EXPECT_EQ(failures(problem, claimsOf(problem, design)), "");
  }
}

TEST(Audit, ScaledCertificatesProveTheSame) {
  const ExplorationProblem problem = thesisProblem(Phase::kSin);
  DesignClaims claims = claimsOf(problem, designExploration(problem));
  claims.multiplier_root *= 1e5;
  EXPECT_EQ(failures(problem, claims), "");
  claims.multiplier_root = Eigen::MatrixXd();
  claims.multiplier *= 1e5;
  EXPECT_EQ(failures(problem, claims), "");
  claims.multiplier = Eigen::MatrixXd();
  claims.certificate *= 1e-7;
  EXPECT_EQ(failures(problem, claims), "");
}

TEST(Audit, FindsABrokenPeakLimitAndForgedPeakMultipliers) {
  ExplorationProblem problem = thesisProblem(Phase::kCos);
  const DesignResult free = designExploration(problem);  // its peak is above 5
  problem.u_max = Eigen::VectorXd::Constant(1, 5.0);
  const DesignResult limited = designExploration(problem);
  ASSERT_TRUE(limited.feasible()) << limited.message;
  const DesignClaims honest = claimsOf(problem, limited);
  ASSERT_EQ(failures(problem, honest), "");
  ASSERT_FALSE(honest.peak_multipliers.empty());

  EXPECT_EQ(failures(problem, claimsOf(problem, free)), "peak ");
  for (const AuditCheck& check : audit(problem, claimsOf(problem, free)).checks) {
    if (check.name != "peak") continue;
    EXPECT_NE(check.finding.find("u_max = 5"), std::string::npos) << check.finding;
  }

  DesignClaims forged = honest;
  for (DesignClaims::Peak& peak : forged.peak_multipliers) peak.value *= 1.5;
  EXPECT_EQ(failures(problem, forged), "lower_bound ");
  forged = honest;
  for (DesignClaims::Peak& peak : forged.peak_multipliers) peak.value *= -1.0;
  EXPECT_EQ(failures(problem, forged), "lower_bound ");
  forged = honest;
  forged.peak_multipliers.front().sample += 20;  // at an instant that does not bind
  EXPECT_EQ(failures(problem, forged), "lower_bound ");
  forged = honest;  // without them the bound is that of the free problem
  forged.peak_multipliers.clear();
  EXPECT_EQ(failures(problem, forged), "lower_bound ");
  forged = honest;
  forged.peak_multipliers.front().sample = 370;
  EXPECT_THROW(audit(problem, forged), quad_support::DataError);
}

/// Unstable for 122 samples: the information spans 13 decades and responses cancel to a thousandth.
TEST(Audit, ProvesTheBoundWhereResponsesGrow) {
  ExplorationProblem problem;
  problem.A = randomMatrix(212, 0, 4, 4);
  problem.A *= 1.09 / problem.A.eigenvalues().cwiseAbs().maxCoeff();
  problem.B = randomMatrix(212, 1, 4, 1);
  problem.lines = {150, {3, 11, 23, 31, 47, 62}, {}};
  problem.phase = Phase::kBoth;
  problem.gamma_w = 2.0;
  problem.D_des = Eigen::MatrixXd::Constant(1, 1, 30.0);
  const DesignResult design = designExploration(problem);
  EXPECT_EQ(design.status, DesignStatus::kSolved) << design.message;
  EXPECT_LT(design.gap, 1e-5);
  const AuditReport report = audit(problem, claimsOf(problem, design));
  for (const AuditCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.finding;
  EXPECT_NEAR(report.lambda_min, 1.0, 1e-9);
}

TEST(Audit, RefusesWhatDoesNotFit) {
  const ExplorationProblem problem = thesisProblem(Phase::kCos);
  const DesignResult design = designExploration(problem);
  DesignClaims claims = claimsOf(problem, design);
  claims.amplitudes = Eigen::MatrixXd::Ones(3, 1);
  EXPECT_THROW(audit(problem, claims), quad_support::DataError);
  claims.amplitudes = Eigen::MatrixXd::Constant(4, 1, NAN);
  EXPECT_THROW(audit(problem, claims), quad_support::DataError);
  for (const char* key : {"amplitudes", "gamma_e", "lower_bound", "gap"}) {
    auto json = designToJson(problem, design);
    json[key] = nullptr;
    EXPECT_THROW(claimsFromJson(json.dump(), "d.json", problem), quad_support::ConfigError) << key;
    json.erase(key);
    EXPECT_THROW(claimsFromJson(json.dump(), "d.json", problem), quad_support::ConfigError) << key;
  }
}
