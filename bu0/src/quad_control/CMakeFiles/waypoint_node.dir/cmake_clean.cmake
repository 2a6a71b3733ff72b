file(REMOVE_RECURSE
  "../../devel/lib/quad_control/waypoint_node"
  "../../devel/lib/quad_control/waypoint_node.pdb"
  "CMakeFiles/waypoint_node.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/waypoint_node.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/waypoint_node.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
