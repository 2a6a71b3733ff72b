# Empty custom commands generated dependencies file for run_tests_quad_support_gtest.
# This may be replaced when dependencies are built.
