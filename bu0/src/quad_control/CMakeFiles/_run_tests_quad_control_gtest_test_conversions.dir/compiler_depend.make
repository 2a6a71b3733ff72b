# Empty custom commands generated dependencies file for _run_tests_quad_control_gtest_test_conversions.
# This may be replaced when dependencies are built.
