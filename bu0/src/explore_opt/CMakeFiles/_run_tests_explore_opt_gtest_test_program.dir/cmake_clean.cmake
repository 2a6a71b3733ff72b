file(REMOVE_RECURSE
  "CMakeFiles/_run_tests_explore_opt_gtest_test_program"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_run_tests_explore_opt_gtest_test_program.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
