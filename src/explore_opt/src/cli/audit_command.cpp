#include <cstdio>
#include <nlohmann/json.hpp>

#include "checks.hpp"
#include "commands.hpp"
#include "explore_opt/audit.hpp"
#include "explore_opt/design_json.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

const char* const kAuditHelp = R"(Example:
  echo '{"A": [[1, 0.1635], [0, 1]], "B": [[0.0214], [0.2617]], "T": 370, "harmonics": [3, 6, 8, 10],
         "phase": "sin", "gamma_w": 20, "D_des": 100}' > problem.json
  explore_opt design problem.json --out design.json
  explore_opt audit problem.json design.json --out audit.json
Recomputes feasibility, cost, bound and gap from the raw data: simulation sample by sample in extended precision, one
eigenvalue problem each for feasibility and bound. Shares no code with the solvers (src/audit.cpp, to be read in minutes).
Says what it checked on standard output with --out, else on standard error, and the JSON on standard output.
Exit code 0: every check passed; 3: one did not; 2: bad input.)";

int runAudit(const AuditSettings& settings) {
  const ExplorationProblem problem =
      problemFromJson(quad_support::readFile(settings.problem), settings.problem);
  const DesignClaims claims =
      claimsFromJson(quad_support::readFile(settings.design), settings.design, problem);
  const AuditReport report = withName(settings.design, [&] { return audit(problem, claims); });
  writeAnswer(settings.out, prettyJson(auditToJson(report)));
  std::FILE* to = settings.out.empty() ? stderr : stdout;
  for (const AuditCheck& check : report.checks) {
    std::fprintf(to, "%-6s %-12s %s\n", check.passed ? "ok" : "WRONG", check.name.c_str(),
                 check.finding.c_str());
  }
  if (report.passed()) return quad_support::kDone;
  std::fprintf(stderr, "explore_opt: %s: the audit found what is wrong\n", settings.design.c_str());
  return quad_support::kNegativeAnswer;
}

}  // namespace explore_opt
