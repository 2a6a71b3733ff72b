file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_random_family"
  "../../devel/lib/explore_opt/test_random_family.pdb"
  "CMakeFiles/test_random_family.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_random_family.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_random_family.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
