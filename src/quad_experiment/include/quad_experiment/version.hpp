/// What was built from what; for provenance.json.
#pragma once

namespace quad_experiment {

extern const char* const kCompiler;
extern const char* const kOdeVersion;
extern const char* const kIpoptVersion;

/// Commit the workspace was built from, "-dirty" with changes on top; "unknown" outside a checkout.
const char* gitState();

}  // namespace quad_experiment
