file(REMOVE_RECURSE
  "../devel/lib/quad_tests/test_rotors_controller"
  "../devel/lib/quad_tests/test_rotors_controller.pdb"
  "CMakeFiles/test_rotors_controller.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_rotors_controller.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_rotors_controller.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
