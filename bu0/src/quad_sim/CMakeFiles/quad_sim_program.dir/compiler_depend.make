# Empty compiler generated dependencies file for quad_sim_program.
# This may be replaced when dependencies are built.
