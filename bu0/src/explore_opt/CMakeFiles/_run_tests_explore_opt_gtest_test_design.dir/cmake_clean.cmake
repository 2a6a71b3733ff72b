file(REMOVE_RECURSE
  "CMakeFiles/_run_tests_explore_opt_gtest_test_design"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_run_tests_explore_opt_gtest_test_design.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
