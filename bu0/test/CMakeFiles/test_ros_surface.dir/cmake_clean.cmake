file(REMOVE_RECURSE
  "../devel/lib/quad_tests/test_ros_surface"
  "../devel/lib/quad_tests/test_ros_surface.pdb"
  "CMakeFiles/test_ros_surface.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_ros_surface.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_ros_surface.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
