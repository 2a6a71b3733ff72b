file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_program"
  "../../devel/lib/explore_opt/test_program.pdb"
  "CMakeFiles/test_program.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_program.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_program.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
