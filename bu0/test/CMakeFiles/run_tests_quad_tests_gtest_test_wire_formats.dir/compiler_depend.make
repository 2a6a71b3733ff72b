# Empty custom commands generated dependencies file for run_tests_quad_tests_gtest_test_wire_formats.
# This may be replaced when dependencies are built.
