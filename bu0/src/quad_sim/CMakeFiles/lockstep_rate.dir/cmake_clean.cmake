file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/lockstep_rate"
  "../../devel/lib/quad_sim/lockstep_rate.pdb"
  "CMakeFiles/lockstep_rate.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/lockstep_rate.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/lockstep_rate.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
