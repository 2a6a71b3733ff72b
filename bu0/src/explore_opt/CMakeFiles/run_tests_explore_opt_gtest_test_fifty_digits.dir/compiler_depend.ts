# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for run_tests_explore_opt_gtest_test_fifty_digits.
