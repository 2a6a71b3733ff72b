file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_baseline_signals"
  "../../devel/lib/explore_opt/test_baseline_signals.pdb"
  "CMakeFiles/test_baseline_signals.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_baseline_signals.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_baseline_signals.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
