# Empty custom commands generated dependencies file for clean_test_results_explore_opt.
# This may be replaced when dependencies are built.
