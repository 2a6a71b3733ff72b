# Empty custom commands generated dependencies file for run_tests_explore_opt.
# This may be replaced when dependencies are built.
