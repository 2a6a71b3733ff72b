# Empty compiler generated dependencies file for test_quad_sim_physics.
# This may be replaced when dependencies are built.
