# Empty custom commands generated dependencies file for _run_tests_quad_tests_rostest_ros_surface.test.
# This may be replaced when dependencies are built.
