#include "quad_support/random_stream.hpp"

#include <Random123/philox.h>

#include <cmath>

namespace quad_support {
namespace {

constexpr double kTwoPi = 6.283185307179586476925286766559;

// The upper 53 bits as the middle of one of 2^53 equal cells of (0, 1): never 0, never 1 (for 1 -
// 2^-54 rounds to 1 - 2^-53), so that the logarithm below is finite.
double unitInterval(std::uint64_t bits) {
  const double cell = static_cast<double>(bits >> 11);
  const double value = (cell + 0.5) * 0x1p-53;
  return value < 1.0 ? value : 1.0 - 0x1p-53;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t run, std::uint64_t stream)
    : seed_(seed), run_(run), stream_(stream) {}

std::array<std::uint64_t, 4> RandomStream::block(std::uint64_t step, std::uint64_t draw) const {
  const r123::Philox4x64::ctr_type counter = {{stream_, step, draw, 0}};
  const r123::Philox4x64::key_type key = {{seed_, run_}};
  const auto out = r123::Philox4x64()(counter, key);
  return {out[0], out[1], out[2], out[3]};
}

double RandomStream::uniform(std::uint64_t step, std::uint64_t draw) const {
  return unitInterval(block(step, draw)[0]);
}

double RandomStream::normal(std::uint64_t step, std::uint64_t draw) const {
  const auto bits = block(step, draw);
  return std::sqrt(-2.0 * std::log(unitInterval(bits[0]))) *
         std::cos(kTwoPi * unitInterval(bits[1]));
}

}  // namespace quad_support
