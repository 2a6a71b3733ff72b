file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/relaxation_instances"
  "../../devel/lib/explore_opt/relaxation_instances.pdb"
  "CMakeFiles/relaxation_instances.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/relaxation_instances.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/relaxation_instances.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
