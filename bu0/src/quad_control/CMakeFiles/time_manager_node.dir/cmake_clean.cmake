file(REMOVE_RECURSE
  "../../devel/lib/quad_control/time_manager_node"
  "../../devel/lib/quad_control/time_manager_node.pdb"
  "CMakeFiles/time_manager_node.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/time_manager_node.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/time_manager_node.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
