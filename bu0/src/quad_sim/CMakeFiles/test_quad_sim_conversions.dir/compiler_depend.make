# Empty compiler generated dependencies file for test_quad_sim_conversions.
# This may be replaced when dependencies are built.
