file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/bench_flight"
  "../../devel/lib/quad_sim/bench_flight.pdb"
  "CMakeFiles/bench_flight.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/bench_flight.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/bench_flight.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
