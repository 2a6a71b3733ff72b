file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_fifty_digits"
  "../../devel/lib/explore_opt/test_fifty_digits.pdb"
  "CMakeFiles/test_fifty_digits.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_fifty_digits.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_fifty_digits.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
