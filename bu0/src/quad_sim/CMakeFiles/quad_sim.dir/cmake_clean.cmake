file(REMOVE_RECURSE
  "../../devel/lib/libquad_sim.pdb"
  "../../devel/lib/libquad_sim.so"
  "CMakeFiles/quad_sim.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_sim.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_sim.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
