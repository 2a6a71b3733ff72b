# Empty custom commands generated dependencies file for _run_tests_quad_experiment_gtest_test_batch.
# This may be replaced when dependencies are built.
