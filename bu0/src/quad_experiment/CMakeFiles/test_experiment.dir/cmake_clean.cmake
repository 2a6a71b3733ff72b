file(REMOVE_RECURSE
  "../../devel/lib/quad_experiment/test_experiment"
  "../../devel/lib/quad_experiment/test_experiment.pdb"
  "CMakeFiles/test_experiment.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_experiment.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_experiment.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
