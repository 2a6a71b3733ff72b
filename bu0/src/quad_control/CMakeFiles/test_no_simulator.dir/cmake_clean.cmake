file(REMOVE_RECURSE
  "../../devel/lib/quad_control/test_no_simulator"
  "../../devel/lib/quad_control/test_no_simulator.pdb"
  "CMakeFiles/test_no_simulator.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_no_simulator.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_no_simulator.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
