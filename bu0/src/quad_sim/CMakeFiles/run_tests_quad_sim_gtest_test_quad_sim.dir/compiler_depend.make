# Empty custom commands generated dependencies file for run_tests_quad_sim_gtest_test_quad_sim.
# This may be replaced when dependencies are built.
