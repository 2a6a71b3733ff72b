/// Counter-based random numbers: any draw can be had alone, in any order, on any thread, and is the
/// same.
#pragma once

#include <array>
#include <cstdint>

namespace quad_support {

/// Random numbers addressed by (seed, run, stream, step): Philox4x64-10 of Random123, keyed by seed
/// and run, counted by stream, step and draw.
class RandomStream {
 public:
  /// @param seed    of the study
  /// @param run     index of the experiment in it
  /// @param stream  what the numbers are for; each purpose has its own (see the callers' constants)
  RandomStream(std::uint64_t seed, std::uint64_t run, std::uint64_t stream);

  /// Uniform in the open interval (0, 1), with 53 random bits.
  double uniform(std::uint64_t step, std::uint64_t draw = 0) const;

  /// Standard normal (Box-Muller of two uniforms of the same block).
  double normal(std::uint64_t step, std::uint64_t draw = 0) const;

 private:
  std::array<std::uint64_t, 4> block(std::uint64_t step, std::uint64_t draw) const;

  std::uint64_t seed_, run_, stream_;
};

}  // namespace quad_support
