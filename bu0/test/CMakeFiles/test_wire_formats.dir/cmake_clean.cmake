file(REMOVE_RECURSE
  "../devel/lib/quad_tests/test_wire_formats"
  "../devel/lib/quad_tests/test_wire_formats.pdb"
  "CMakeFiles/test_wire_formats.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_wire_formats.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_wire_formats.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
