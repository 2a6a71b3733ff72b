file(REMOVE_RECURSE
  "../../devel/lib/quad_control/attitude_altitude_controller_node"
  "../../devel/lib/quad_control/attitude_altitude_controller_node.pdb"
  "CMakeFiles/attitude_altitude_controller_node.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/attitude_altitude_controller_node.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/attitude_altitude_controller_node.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
