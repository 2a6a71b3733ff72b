file(REMOVE_RECURSE
  "CMakeFiles/clean_test_results_quad_tests"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/clean_test_results_quad_tests.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
