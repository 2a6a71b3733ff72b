# Empty custom commands generated dependencies file for run_tests_quad_support_gtest_test_support.
# This may be replaced when dependencies are built.
