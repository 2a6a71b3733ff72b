file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/test_quad_sim"
  "../../devel/lib/quad_sim/test_quad_sim.pdb"
  "CMakeFiles/test_quad_sim.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_quad_sim.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_quad_sim.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
