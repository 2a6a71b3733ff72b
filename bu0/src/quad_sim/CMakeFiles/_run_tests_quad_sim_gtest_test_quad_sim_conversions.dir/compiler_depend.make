# Empty custom commands generated dependencies file for _run_tests_quad_sim_gtest_test_quad_sim_conversions.
# This may be replaced when dependencies are built.
