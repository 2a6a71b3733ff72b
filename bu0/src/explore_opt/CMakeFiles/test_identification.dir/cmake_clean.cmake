file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_identification"
  "../../devel/lib/explore_opt/test_identification.pdb"
  "CMakeFiles/test_identification.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_identification.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_identification.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
