file(REMOVE_RECURSE
  "../../devel/lib/quad_control/test_wallclock"
  "../../devel/lib/quad_control/test_wallclock.pdb"
  "CMakeFiles/test_wallclock.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_wallclock.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_wallclock.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
