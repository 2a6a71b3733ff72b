file(REMOVE_RECURSE
  "CMakeFiles/run_tests_quad_tests_rostest_gazebo_services__urdf__work_wt_unity_bu0_urdf_hummingbird.urdf.test"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_tests_rostest_gazebo_services__urdf__work_wt_unity_bu0_urdf_hummingbird.urdf.test.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
