file(REMOVE_RECURSE
  "../../devel/lib/quad_experiment/bench_experiment"
  "../../devel/lib/quad_experiment/bench_experiment.pdb"
  "CMakeFiles/bench_experiment.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/bench_experiment.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/bench_experiment.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
