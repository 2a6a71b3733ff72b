file(REMOVE_RECURSE
  "../../devel/lib/quad_control/test_control"
  "../../devel/lib/quad_control/test_control.pdb"
  "CMakeFiles/test_control.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_control.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_control.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
