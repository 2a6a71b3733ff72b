file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_relaxation"
  "../../devel/lib/explore_opt/test_relaxation.pdb"
  "CMakeFiles/test_relaxation.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_relaxation.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_relaxation.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
