# Empty custom commands generated dependencies file for _run_tests_explore_opt_gtest_test_program.
# This may be replaced when dependencies are built.
