file(REMOVE_RECURSE
  "../../devel/lib/libquad_sim_ros.pdb"
  "../../devel/lib/libquad_sim_ros.so"
  "CMakeFiles/quad_sim_ros.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_sim_ros.dir/Unity/unity_0_cxx.cxx.o.d"
  "CMakeFiles/quad_sim_ros.dir/src/ros/bag_recorder.cpp.o"
  "CMakeFiles/quad_sim_ros.dir/src/ros/bag_recorder.cpp.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_sim_ros.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
