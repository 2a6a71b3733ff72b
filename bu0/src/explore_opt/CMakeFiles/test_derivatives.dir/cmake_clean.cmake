file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_derivatives"
  "../../devel/lib/explore_opt/test_derivatives.pdb"
  "CMakeFiles/test_derivatives.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_derivatives.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_derivatives.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
