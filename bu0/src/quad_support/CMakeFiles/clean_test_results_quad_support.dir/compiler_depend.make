# Empty custom commands generated dependencies file for clean_test_results_quad_support.
# This may be replaced when dependencies are built.
