file(REMOVE_RECURSE
  "CMakeFiles/run_tests_quad_experiment_gtest_test_batch"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_experiment_gtest_test_batch.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
