# Empty custom commands generated dependencies file for run_tests_quad_experiment_gtest_test_experiment.
# This may be replaced when dependencies are built.
