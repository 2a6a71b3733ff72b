# Empty custom commands generated dependencies file for run_tests_quad_control_rostest_test_wallclock.test.
# This may be replaced when dependencies are built.
