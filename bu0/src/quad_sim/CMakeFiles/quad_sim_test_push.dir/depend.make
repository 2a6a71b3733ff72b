# Empty dependencies file for quad_sim_test_push.
# This may be replaced when dependencies are built.
