/// Options that several files of these tests fly with.
#pragma once

#include "quad_sim/simulator.hpp"

namespace quad_sim {

inline SimulatorOptions inTheAir(double step = 0.001) {
  SimulatorOptions options;
  options.step = step;
  options.ground = false;
  return options;
}

}  // namespace quad_sim
