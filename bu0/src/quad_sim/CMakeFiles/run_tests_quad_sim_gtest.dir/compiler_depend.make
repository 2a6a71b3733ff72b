# Empty custom commands generated dependencies file for run_tests_quad_sim_gtest.
# This may be replaced when dependencies are built.
