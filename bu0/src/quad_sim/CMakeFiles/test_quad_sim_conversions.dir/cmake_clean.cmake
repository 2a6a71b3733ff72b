file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/test_quad_sim_conversions"
  "../../devel/lib/quad_sim/test_quad_sim_conversions.pdb"
  "CMakeFiles/test_quad_sim_conversions.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_quad_sim_conversions.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_quad_sim_conversions.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
