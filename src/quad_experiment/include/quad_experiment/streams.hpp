/// Which random stream serves which purpose (see quad_support::RandomStream). A number is never
/// given to a second purpose.
#pragma once

#include <cstdint>

namespace quad_experiment {

/// Flights of one experiment, in the order flown.
enum Flight : std::uint64_t { kTargetedFlight = 0, kGaussianFlight = 1 };

constexpr std::uint64_t kJitterStream = 0x100;  ///< + flight: interval lengths
constexpr std::uint64_t kSignalStream = 0x200;  ///< + flight: random exploration signals
constexpr std::uint64_t kCompareStreams =
    0x300;  ///< + kind: signals a targeted one is compared with
/// Settings drawn in a batch: the lower bits are a hash of the key's name.
constexpr std::uint64_t kVaryStreams = 0x1000000000000000;

}  // namespace quad_experiment
