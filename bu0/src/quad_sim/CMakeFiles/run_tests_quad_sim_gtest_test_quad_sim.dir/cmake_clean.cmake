file(REMOVE_RECURSE
  "CMakeFiles/run_tests_quad_sim_gtest_test_quad_sim"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_sim_gtest_test_quad_sim.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
