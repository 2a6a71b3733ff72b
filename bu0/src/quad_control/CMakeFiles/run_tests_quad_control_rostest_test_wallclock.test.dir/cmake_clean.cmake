file(REMOVE_RECURSE
  "CMakeFiles/run_tests_quad_control_rostest_test_wallclock.test"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_control_rostest_test_wallclock.test.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
