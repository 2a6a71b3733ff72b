# Empty custom commands generated dependencies file for run_tests_quad_tests_rostest_integration_experiment_node.test.
# This may be replaced when dependencies are built.
