/// Wrenches that users put on a vehicle from one instant to another: /gazebo/apply_body_wrench.
#pragma once

#include <cstdint>
#include <vector>

#include "quad_sim/simulator.hpp"

namespace quad_sim {

struct Push {
  Wrench wrench;
  std::int64_t start_ns = 0, end_ns = 0;  ///< simulated time; end not included

  static constexpr std::int64_t kForEver = std::int64_t{1} << 52;  ///< 52 days; a double holds it
};

/// The pushes on one vehicle. Their sum is the simulator's push; it changes at the first step that
/// starts at or after a start or an end.
class Pushes {
 public:
  explicit Pushes(Simulator& simulator) : simulator_(simulator) {}

  void add(const Push& push);  ///< @throws std::invalid_argument if not finite
  void clear();
  std::int64_t nextEvent() const;  ///< step at which apply() must be called next
  void apply();                    ///< gives the simulator what is in force now
  void archive(StateArchive& archive);

 private:
  Simulator& simulator_;
  std::vector<Push> pushes_;  ///< those that have not ended
};

}  // namespace quad_sim
