file(REMOVE_RECURSE
  "../../devel/lib/quad_experiment/quad_experiment_node"
  "../../devel/lib/quad_experiment/quad_experiment_node.pdb"
  "CMakeFiles/quad_experiment_node.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_experiment_node.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_experiment_node.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
