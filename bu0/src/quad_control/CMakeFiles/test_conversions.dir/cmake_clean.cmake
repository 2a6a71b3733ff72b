file(REMOVE_RECURSE
  "../../devel/lib/quad_control/test_conversions"
  "../../devel/lib/quad_control/test_conversions.pdb"
  "CMakeFiles/test_conversions.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_conversions.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_conversions.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
