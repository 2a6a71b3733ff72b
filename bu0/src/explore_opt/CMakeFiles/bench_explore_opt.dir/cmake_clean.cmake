file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/bench_explore_opt"
  "../../devel/lib/explore_opt/bench_explore_opt.pdb"
  "CMakeFiles/bench_explore_opt.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/bench_explore_opt.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/bench_explore_opt.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
