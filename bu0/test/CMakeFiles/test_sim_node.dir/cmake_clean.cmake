file(REMOVE_RECURSE
  "../devel/lib/quad_tests/test_sim_node"
  "../devel/lib/quad_tests/test_sim_node.pdb"
  "CMakeFiles/test_sim_node.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_sim_node.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_sim_node.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
