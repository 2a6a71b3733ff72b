file(REMOVE_RECURSE
  "CMakeFiles/run_tests_quad_tests_gtest_test_newton_euler"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_tests_gtest_test_newton_euler.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
