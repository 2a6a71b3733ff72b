# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for run_tests_quad_tests_rostest_gazebo_services__urdf__work_wt_unity_bu0_urdf_hummingbird.urdf.test.
