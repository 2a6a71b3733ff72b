file(REMOVE_RECURSE
  "../../devel/lib/libquad_sim_test_push.pdb"
  "../../devel/lib/libquad_sim_test_push.so"
  "CMakeFiles/quad_sim_test_push.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_sim_test_push.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_sim_test_push.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
