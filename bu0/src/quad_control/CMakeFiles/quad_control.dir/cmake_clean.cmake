file(REMOVE_RECURSE
  "../../devel/lib/libquad_control.pdb"
  "../../devel/lib/libquad_control.so"
  "CMakeFiles/quad_control.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_control.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_control.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
