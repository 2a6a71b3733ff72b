file(REMOVE_RECURSE
  "../../devel/lib/quad_control/test_nodes"
  "../../devel/lib/quad_control/test_nodes.pdb"
  "CMakeFiles/test_nodes.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_nodes.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_nodes.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
