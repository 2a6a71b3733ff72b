# Empty custom commands generated dependencies file for _run_tests_quad_control_rostest_test_nodes.test.
# This may be replaced when dependencies are built.
