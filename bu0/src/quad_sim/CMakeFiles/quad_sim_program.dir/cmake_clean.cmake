file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/quad_sim"
  "../../devel/lib/quad_sim/quad_sim.pdb"
  "CMakeFiles/quad_sim_program.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_sim_program.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_sim_program.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
