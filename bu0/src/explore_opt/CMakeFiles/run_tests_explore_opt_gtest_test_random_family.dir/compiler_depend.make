# Empty custom commands generated dependencies file for run_tests_explore_opt_gtest_test_random_family.
# This may be replaced when dependencies are built.
