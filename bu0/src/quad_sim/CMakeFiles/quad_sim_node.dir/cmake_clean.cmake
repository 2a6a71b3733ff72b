file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/quad_sim_node"
  "../../devel/lib/quad_sim/quad_sim_node.pdb"
  "CMakeFiles/quad_sim_node.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_sim_node.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_sim_node.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
