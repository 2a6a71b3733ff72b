/// Specs of small batches, and the rows they fly.
#pragma once

#include "quad_experiment/batch.hpp"
#include "quad_experiment/batch_row.hpp"
#include "quad_experiment/design_memory.hpp"
#include "scratch.hpp"

namespace quad_experiment {

/// A spec on config/smoke.yaml in a folder of its own.
class SpecFile {
 public:
  explicit SpecFile(const std::string& rest) {
    quad_support::writeFileAtomically(scratch_.path("smoke.yaml"), shippedConfig("smoke.yaml"));
    quad_support::writeFileAtomically(path(), "base: smoke.yaml\n" + rest);
  }
  std::string path() const { return scratch_.path("spec.yaml"); }
  std::string in(const std::string& name) const { return scratch_.path(name); }
  BatchSpec read(std::int64_t repeats = 0) const { return readBatchSpec(path(), repeats); }

 private:
  Scratch scratch_;
};

inline std::string rows(const BatchSpec& spec, RunRange runs) {
  std::string text;
  DesignMemory designs;
  for (std::int64_t run = runs.first; run < runs.last; ++run)
    text += flyBatchRun(spec, run, designs);
  return text;
}

}  // namespace quad_experiment
