# Empty custom commands generated dependencies file for run_tests_explore_opt_gtest_test_baseline_signals.
# This may be replaced when dependencies are built.
