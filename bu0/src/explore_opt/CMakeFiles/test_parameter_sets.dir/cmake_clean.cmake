file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_parameter_sets"
  "../../devel/lib/explore_opt/test_parameter_sets.pdb"
  "CMakeFiles/test_parameter_sets.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_parameter_sets.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_parameter_sets.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
