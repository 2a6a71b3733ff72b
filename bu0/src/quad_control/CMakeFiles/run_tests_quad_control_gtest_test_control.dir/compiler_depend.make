# Empty custom commands generated dependencies file for run_tests_quad_control_gtest_test_control.
# This may be replaced when dependencies are built.
