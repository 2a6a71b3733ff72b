file(REMOVE_RECURSE
  "CMakeFiles/_run_tests_quad_sim_gtest_test_quad_sim_conversions"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_run_tests_quad_sim_gtest_test_quad_sim_conversions.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
