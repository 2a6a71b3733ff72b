file(REMOVE_RECURSE
  "../../devel/lib/libquad_control_ros.a"
  "../../devel/lib/libquad_control_ros.pdb"
  "CMakeFiles/quad_control_ros.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_control_ros.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_control_ros.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
