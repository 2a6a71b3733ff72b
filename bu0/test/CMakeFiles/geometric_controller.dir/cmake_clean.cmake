file(REMOVE_RECURSE
  "../devel/lib/quad_tests/geometric_controller"
  "../devel/lib/quad_tests/geometric_controller.pdb"
  "CMakeFiles/geometric_controller.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/geometric_controller.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/geometric_controller.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
