file(REMOVE_RECURSE
  "../devel/lib/quad_tests/test_newton_euler"
  "../devel/lib/quad_tests/test_newton_euler.pdb"
  "CMakeFiles/test_newton_euler.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_newton_euler.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_newton_euler.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
