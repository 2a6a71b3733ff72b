file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/bench_hinged"
  "../../devel/lib/quad_sim/bench_hinged.pdb"
  "CMakeFiles/bench_hinged.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/bench_hinged.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/bench_hinged.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
