/// One experiment of a batch as one row of a table.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "quad_experiment/batch_spec.hpp"
#include "quad_experiment/design_memory.hpp"

namespace quad_experiment {

/// How a run ended. Everything but kOk has no promise kept; what each means stands in
/// docs/batch.md.
enum class RunStatus {
  kOk,
  kFalsified,
  kConditionNotMet,
  kObjectiveMissed,
  kInfeasible,
  kGroundContact,
  kDiverged,
  kBadInput,
  kCrashed,
  kTimeout,
};
const char* toString(RunStatus status);  ///< "ok", "falsified", "condition_not_met", …
int exitCodeOf(RunStatus status);        ///< of `quad_experiment run` with the same settings

/// The header of results.csv: run, the varied keys, status, exit_code, numbers of summary.json.
std::vector<std::string> batchColumns(const BatchSpec& spec);

/// Flies a run in this process. A failure is a row.
/// @returns the row with its line end
/// @throws quad_support::EnvironmentError, quad_support::Interrupted, std::bad_alloc: no row
std::string flyBatchRun(const BatchSpec& spec, std::int64_t run, DesignMemory& designs);

/// The row of a run that has a summary.json, or that ended without one.
std::string batchRow(const BatchSpec& spec, std::int64_t run,
                     const nlohmann::ordered_json& summary);
std::string batchRow(const BatchSpec& spec, std::int64_t run, RunStatus status);

/// The cells of a row written here; quotes taken off.
std::vector<std::string> splitBatchRow(std::string_view row);

}  // namespace quad_experiment
