file(REMOVE_RECURSE
  "CMakeFiles/_run_tests_quad_support_gtest_test_support"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_run_tests_quad_support_gtest_test_support.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
