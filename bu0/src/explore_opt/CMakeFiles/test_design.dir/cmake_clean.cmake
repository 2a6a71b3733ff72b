file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_design"
  "../../devel/lib/explore_opt/test_design.pdb"
  "CMakeFiles/test_design.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_design.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_design.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
