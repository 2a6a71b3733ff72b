file(REMOVE_RECURSE
  "../../devel/lib/quad_support/test_support"
  "../../devel/lib/quad_support/test_support.pdb"
  "CMakeFiles/test_support.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_support.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_support.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
