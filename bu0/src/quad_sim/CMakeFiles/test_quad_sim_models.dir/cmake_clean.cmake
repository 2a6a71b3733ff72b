file(REMOVE_RECURSE
  "../../devel/lib/quad_sim/test_quad_sim_models"
  "../../devel/lib/quad_sim/test_quad_sim_models.pdb"
  "CMakeFiles/test_quad_sim_models.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_quad_sim_models.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_quad_sim_models.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
