# Empty custom commands generated dependencies file for _run_tests_quad_tests_rostest_gazebo_services__urdf__work_wt_unity_bu0_urdf_hummingbird.urdf.test.
# This may be replaced when dependencies are built.
