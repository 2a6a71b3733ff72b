file(REMOVE_RECURSE
  "CMakeFiles/run_tests_explore_opt_gtest_test_baselines"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_explore_opt_gtest_test_baselines.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
