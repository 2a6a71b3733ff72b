# Empty custom commands generated dependencies file for clean_test_results_quad_control.
# This may be replaced when dependencies are built.
