file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_bad_problems"
  "../../devel/lib/explore_opt/test_bad_problems.pdb"
  "CMakeFiles/test_bad_problems.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_bad_problems.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_bad_problems.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
