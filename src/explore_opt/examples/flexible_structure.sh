#!/bin/sh
# From a model to a verdict with the program alone. Run it in an empty folder, explore_opt in PATH:
#   flexible_structure.sh <folder of flexible_structure.json>
set -e
problem=$1/flexible_structure.json

# Lines where the structure answers most, instead of every tenth harmonic.
explore_opt frequencies "$problem" --lines 12 --problem problem.json --out bode.json

# The least amplitude that guarantees the accuracy, with proof, and what other signals would cost.
explore_opt design problem.json --out design.json --dump dump.json
explore_opt baselines problem.json --seeds 3 --out baselines.json

# A second opinion from the raw data.
explore_opt audit problem.json design.json

# The experiment, here without noise, and what it tells.
explore_opt predict problem.json design.json --out data.csv
explore_opt identify data.csv --states x1,x2,x3,x4,x5,x6,x7,x8,x9,x10 --inputs u1 --gamma-w 1 \
  --function 'damping = 1 - A11' --out model.json

# The solve again, elsewhere or later.
explore_opt replay dump.json --out again.json
