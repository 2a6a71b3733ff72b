file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_baselines"
  "../../devel/lib/explore_opt/test_baselines.pdb"
  "CMakeFiles/test_baselines.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_baselines.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_baselines.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
