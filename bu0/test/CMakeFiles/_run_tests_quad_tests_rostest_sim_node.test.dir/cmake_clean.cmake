file(REMOVE_RECURSE
  "CMakeFiles/_run_tests_quad_tests_rostest_sim_node.test"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_run_tests_quad_tests_rostest_sim_node.test.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
