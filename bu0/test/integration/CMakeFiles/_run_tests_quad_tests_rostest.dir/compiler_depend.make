# Empty custom commands generated dependencies file for _run_tests_quad_tests_rostest.
# This may be replaced when dependencies are built.
