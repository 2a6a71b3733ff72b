file(REMOVE_RECURSE
  "../../devel/lib/libquad_support.pdb"
  "../../devel/lib/libquad_support.so"
  "CMakeFiles/quad_support.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_support.dir/Unity/unity_0_cxx.cxx.o.d"
  "CMakeFiles/quad_support.dir/src/linear_algebra.cpp.o"
  "CMakeFiles/quad_support.dir/src/linear_algebra.cpp.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_support.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
