# Empty dependencies file for quad_sim.
# This may be replaced when dependencies are built.
