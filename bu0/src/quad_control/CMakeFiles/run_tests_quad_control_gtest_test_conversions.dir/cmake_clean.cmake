file(REMOVE_RECURSE
  "CMakeFiles/run_tests_quad_control_gtest_test_conversions"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_control_gtest_test_conversions.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
